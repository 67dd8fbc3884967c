open Raylab_geometry

type source =
  | Directional of Direction.t
  | Spherical of Vec3.t
  | Spot of Beam.t
  | Area of Pane.t

type t = {
  source : source;
  intensity : float;
  color : Color.t;
  power : Color.t; (* intensity * color *)
  is_unfading : bool;
  origin : Origin.t;
}

let power intensity color = Saturate.color (Color.scale intensity color)

let make ~intensity ~color source =
  Number.require Non_negative "an intensity" intensity;
  Color.require "a light's colour" color;
  let power = power intensity color in
  { source; intensity; color; power; is_unfading = false; origin = Unknown }

let directional ~intensity ~color ~direction =
  make ~intensity ~color (Directional (Direction.of_vec3_exn direction))

let spherical_at position =
  if not (Vec3.is_finite position) then
    invalid_arg "a light's position must be finite";
  Spherical position

let spherical ~intensity ~color ~position =
  make ~intensity ~color (spherical_at position)

let spot ~intensity ~color beam = make ~intensity ~color (Spot beam)
let area ~intensity ~color pane = make ~intensity ~color (Area pane)
let unfading light = { light with is_unfading = true }

(* A direction goes where the way between two points would. *)
let transformed change light =
  let point, direction, vector =
    match Change.similarity change with
    | Some s ->
        let direction = Similarity.direction s in
        let vector v = Vec3.scale (Similarity.factor s) (direction v) in
        (Similarity.point s, direction, vector)
    | None ->
        let affine = Change.affine change in
        Affine.(point affine, vector affine, vector affine)
  in
  let source =
    match light.source with
    | Directional along ->
        let along = direction (along :> Vec3.t) in
        Directional (Direction.of_vec3_exn along)
    | Spherical position -> spherical_at (point position)
    | Spot { position; target; inner; outer; _ } ->
        let position = point position and target = point target in
        Spot (Beam.make_exn ~position ~target ~inner ~outer)
    | Area pane -> Area (Pane.transformed ~point ~vector pane)
  in
  { light with source }

(* {1 Where it shines from} *)

let points light =
  match light.source with
  | Directional _ | Spherical _ | Spot _ -> 1
  | Area pane -> Pane.points pane

let places light =
  match light.source with
  | Directional _ -> []
  | Spherical position | Spot { position; _ } -> [ position ]
  | Area pane -> Pane.corners pane

let fan light =
  match light.source with
  | Directional along -> Some (Fan.Along along)
  | Spherical position | Spot { position; _ } -> Some (Fan.Point position)
  | Area _ -> None

(* {1 Forms} *)

let name light =
  match light.source with
  | Directional _ -> "directional"
  | Spherical _ -> "spherical"
  | Spot _ -> "spot"
  | Area _ -> "area"

let parameters light =
  let vector name v = (name, Parameter.of_vec3 v)
  and number name x = (name, Parameter.Number x) in
  match light.source with
  | Directional along -> [ vector "direction" (along :> Vec3.t) ]
  | Spherical position -> [ vector "position" position ]
  | Spot { position; target; inner; outer; _ } ->
      [
        vector "position" position;
        vector "target" target;
        number "inner" inner;
        number "outer" outer;
      ]
  | Area { corner; edge; other; count } ->
      [
        vector "corner" corner;
        vector "edge" edge;
        vector "other" other;
        number "count" (float_of_int count);
      ]

let with_origin origin light = { light with origin }

let map_color f ({ intensity; color; _ } as light) =
  let color = f color in
  Color.require "a light's colour" color;
  { light with color; power = power intensity color }

let equal_source a b =
  match (a, b) with
  | Directional a, Directional b -> Vec3.equal (a :> Vec3.t) (b :> Vec3.t)
  | Spherical a, Spherical b -> Vec3.equal a b
  | Spot a, Spot b -> Beam.equal a b
  | Area a, Area b -> Pane.equal a b
  | (Directional _ | Spherical _ | Spot _ | Area _), _ -> false

let equal a b =
  equal_source a.source b.source
  && a.intensity = b.intensity
  && Color.equal a.color b.color
  && a.is_unfading = b.is_unfading

let pp_parameter ppf (name, parameter) =
  match (parameter : Parameter.t) with
  | Number x -> Format.fprintf ppf ", %s %a" name Number.pp x
  | Triple (x, y, z) ->
      Format.fprintf ppf ", %s %a" name Vec3.pp (Vec3.make x y z)
  | (Text _ | Word _) as other ->
      Format.fprintf ppf ", %s %a" name (Parameter.pp_with Number.pp) other

let pp ppf light =
  Format.fprintf ppf "%s light, intensity %a, %a" (name light) Number.pp
    light.intensity Color.pp light.color;
  List.iter (pp_parameter ppf) (parameters light);
  if light.is_unfading then Format.pp_print_string ppf ", unfading"
