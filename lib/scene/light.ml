open Raylab_geometry

type source = Directional of Direction.t | Spherical of Vec3.t

type t = {
  source : source;
  intensity : float;
  color : Color.t;
  line : int option;
}

let make ~intensity ~color source =
  Number.require Non_negative "an intensity" intensity;
  Color.require "a light's colour" color;
  { source; intensity; color; line = None }

let directional ~intensity ~color ~direction =
  make ~intensity ~color (Directional (Direction.of_vec3_exn direction))

let spherical ~intensity ~color ~position =
  if not (Vec3.is_finite position) then
    invalid_arg "a light's position must be finite";
  make ~intensity ~color (Spherical position)

type incidence = { towards : Direction.t; cosine : float; falloff : float }

let cosine (u : Direction.t) (v : Direction.t) =
  Vec3.dot (u :> Vec3.t) (v :> Vec3.t)

let incidence light ~point ~normal =
  match light.source with
  | Directional along ->
      let towards = Direction.neg along in
      Some { towards; cosine = cosine towards normal; falloff = 1. }
  | Spherical position ->
      let way = Vec3.sub position point in
      let with_direction towards =
        {
          towards;
          cosine = cosine towards normal;
          falloff = Saturate.limit (1. /. Vec3.length_squared way);
        }
      in
      Option.map with_direction (Direction.of_vec3 way)

let power light = Saturate.color (Color.scale light.intensity light.color)

let contribution ~power { cosine; falloff; _ } =
  if cosine > 0. then Saturate.color (Color.scale (cosine *. falloff) power)
  else Color.black

let received light ~point ~normal =
  match incidence light ~point ~normal with
  | None -> Color.black
  | Some incidence -> contribution ~power:(power light) incidence

let shadow_ray light ~point ~normal ~offset =
  let origin =
    Vec3.add point (Vec3.scale offset (normal : Direction.t :> Vec3.t))
  in
  match light.source with
  | Directional along ->
      Some (Ray.make ~origin ~direction:(Direction.neg along))
  | Spherical position -> Ray.towards ~origin ~target:position ~short:offset

let blocks shadow_ray t = 0. < t && t < Ray.reach shadow_ray

let name light =
  match light.source with
  | Directional _ -> "directional"
  | Spherical _ -> "spherical"

let with_line line light = { light with line }

let map_color f { source; intensity; color; line } =
  with_line line (make ~intensity ~color:(f color) source)

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
