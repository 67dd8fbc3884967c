open Raylab_geometry

type source = Directional of Direction.t | Spherical of Vec3.t

type t = {
  source : source;
  intensity : float;
  color : Color.t;
  power : Color.t; (* intensity * color *)
  origin : Origin.t;
}

let make ~intensity ~color source =
  Number.require Non_negative "an intensity" intensity;
  Color.require "a light's colour" color;
  let power = Saturate.color (Color.scale intensity color) in
  { source; intensity; color; power; origin = Unknown }

let directional ~intensity ~color ~direction =
  make ~intensity ~color (Directional (Direction.of_vec3_exn direction))

let spherical ~intensity ~color ~position =
  if not (Vec3.is_finite position) then
    invalid_arg "a light's position must be finite";
  make ~intensity ~color (Spherical position)

(* A direction goes where the way between two points would. *)
let transformed change light =
  let point, vector =
    match Change.similarity change with
    | Some s -> Similarity.(point s, direction s)
    | None ->
        let affine = Change.affine change in
        Affine.(point affine, vector affine)
  in
  match light.source with
  | Directional direction ->
      let direction = vector (direction :> Vec3.t) in
      { light with source = Directional (Direction.of_vec3_exn direction) }
  | Spherical position ->
      let position = point position in
      if not (Vec3.is_finite position) then
        invalid_arg "a light's position must be finite";
      { light with source = Spherical position }

(* {1 What reaches a point} *)

type incidence = { mutable cosine : float; mutable falloff : float }

let create_incidence () = { cosine = 0.; falloff = 0. }

(* A light whose distance cannot be squared gives nothing. The limit of the
   offset sees to it that the way of the shadow ray can be squared as well. *)
let[@inline] is_within_squares squared (spot : Spot.t) =
  squared > 0. && squared < Offset.farthest && spot.offset < 0x1p500

(* Both the surface and its normal for shading must face along the way (x, y,
   z), which is [length] long; the cosine is that of the latter, or of the
   surface if that alone turns away. *)
let[@inline] face (spot : Spot.t) x y z ~length incidence =
  let shaded =
    (spot.shading_x *. x) +. (spot.shading_y *. y) +. (spot.shading_z *. z)
  and flat = (spot.nx *. x) +. (spot.ny *. y) +. (spot.nz *. z) in
  let cosine = (if flat > 0. then shaded else flat) /. length in
  incidence.cosine <- cosine;
  flat > 0. && cosine > 0.

let[@inline] meet light (spot : Spot.t) incidence =
  match light.source with
  | Directional along ->
      let { Vec3.x; y; z } = (along :> Vec3.t) in
      incidence.falloff <- 1.;
      face spot (-.x) (-.y) (-.z) ~length:1. incidence
  | Spherical { x; y; z } ->
      let wx = x -. spot.x and wy = y -. spot.y and wz = z -. spot.z in
      let squared = (wx *. wx) +. (wy *. wy) +. (wz *. wz) in
      if is_within_squares squared spot then (
        incidence.falloff <- Saturate.limit (1. /. squared);
        face spot wx wy wz ~length:(sqrt squared) incidence)
      else (
        incidence.cosine <- 0.;
        incidence.falloff <- 0.;
        false)

(* cosine * falloff * intensity * colour *)
let[@inline] add light { cosine; falloff } (sum : Raw_color.t) =
  let k = Saturate.limit (cosine *. falloff)
  and { Color.r; g; b } = light.power in
  Raw_color.set sum
    (sum.r +. Saturate.limit (k *. r))
    (sum.g +. Saturate.limit (k *. g))
    (sum.b +. Saturate.limit (k *. b))

let received light ~point ~normal =
  let incidence = create_incidence () and sum = Raw_color.create () in
  if meet light (Spot.of_point ~point ~normal ~offset:0.) incidence then
    add light incidence sum;
  Raw_color.to_color sum

(* {1 Shadows} *)

let[@inline] aim light (spot : Spot.t) (ray : Raw_ray.t) =
  match light.source with
  | Directional along ->
      let { Vec3.x; y; z } = (along :> Vec3.t) in
      Raw_ray.set_direction ray (-.x) (-.y) (-.z);
      ray.reach <- infinity;
      true
  | Spherical { x; y; z } ->
      let vx = x -. ray.ox and vy = y -. ray.oy and vz = z -. ray.oz in
      let way = sqrt ((vx *. vx) +. (vy *. vy) +. (vz *. vz)) in
      let scale = 1. /. way in
      Raw_ray.set_direction ray (vx *. scale) (vy *. scale) (vz *. scale);
      ray.reach <- way -. spot.offset;
      way > 0. && way < infinity

let shadow_ray light ~point ~normal ~offset =
  let ray = Raw_ray.create ()
  and spot = Spot.of_point ~point ~normal ~offset in
  Spot.start spot ray;
  if aim light spot ray then Some (Ray.of_raw ray) else None

(* {1 Forms} *)

let name light =
  match light.source with
  | Directional _ -> "directional"
  | Spherical _ -> "spherical"

let with_origin origin light = { light with origin }

let map_color f { source; intensity; color; origin; _ } =
  with_origin origin (make ~intensity ~color:(f color) source)

let equal_source a b =
  match (a, b) with
  | Directional a, Directional b -> Vec3.equal (a :> Vec3.t) (b :> Vec3.t)
  | Spherical a, Spherical b -> Vec3.equal a b
  | (Directional _ | Spherical _), _ -> false

let equal a b =
  equal_source a.source b.source
  && a.intensity = b.intensity
  && Color.equal a.color b.color

let pp ppf light =
  let place ppf = function
    | Directional along -> Format.fprintf ppf "direction %a" Direction.pp along
    | Spherical position -> Format.fprintf ppf "position %a" Vec3.pp position
  in
  Format.fprintf ppf "%s light, intensity %a, %a, %a" (name light) Number.pp
    light.intensity Color.pp light.color place light.source
