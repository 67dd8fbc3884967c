open Raylab_geometry
open Raylab_expression

type t =
  | Plain of Color.t
  | Varying of { pattern : Surface.t Closed.t; grey : bool }

let plain color =
  Color.require "the background" color;
  Plain color

let varying pattern = Varying { pattern; grey = false }
let grey c = Grey.(to_color (of_color c))

type reader =
  | Constant of Color.t
  | Machine of {
      machine : Surface.t Closed.machine;
      read : Surface.t Value.run -> Surface.t Value.t -> Color.t;
    }

let reader = function
  | Plain color -> Constant color
  | Varying { pattern; grey = is_grey } ->
      let make = Surface.make ~color:Fun.id in
      let read run value =
        let color = Pattern.color "the background" run pattern.body value in
        if is_grey then grey color else color
      in
      Machine { machine = Pattern.start ~make (Closed.compile pattern); read }

let at_point reader point =
  match reader with
  | Constant color -> color
  | Machine { machine; read } -> Pattern.value machine point read

let read_at = at_point
let at background direction = at_point (reader background) direction

let read reader (ray : Raw_ray.t) raw =
  let { Color.r; g; b } =
    match reader with
    | Constant color -> color
    | Machine _ -> at_point reader (Vec3.make ray.dx ray.dy ray.dz)
  in
  Raw_color.set raw r g b

let greyscale = function
  | Plain color -> Plain (grey color)
  | Varying { pattern; _ } -> Varying { pattern; grey = true }

let probes =
  let direction x y z = (Direction.of_vec3_exn (Vec3.make x y z) :> Vec3.t) in
  [
    direction 0. 1. 0.; direction 0. 0.1 1.; direction 1. 0.3 0.2;
    direction (-1.) 0.5 0.4; direction 0.1 0. (-1.); direction 0. (-1.) 0.1;
  ]
[@@ocamlformat "disable"]

let colors background =
  let reader = reader background in
  let color direction =
    try Some (at_point reader direction) with Pattern.Failed _ -> None
  in
  match background with
  | Plain color -> [ color ]
  | Varying _ -> List.filter_map color probes

let equal a b =
  match (a, b) with
  | Plain a, Plain b -> Color.equal a b
  | Varying a, Varying b ->
      a.grey = b.grey && Closed.equal Surface.equal a.pattern b.pattern
  | (Plain _ | Varying _), _ -> false

let pp ppf = function
  | Plain color -> Color.pp ppf color
  | Varying { pattern = { name; body; _ }; _ } ->
      Format.fprintf ppf "varying %s%a" name Expression.pp_bare (Color, body)
