open Raylab_scene
open Raylab_tracer

let bytes (r, g, b) = Printf.sprintf "rgb %d %d %d" r g b
let subject (e : Explain.t) = "the ray is " ^ bytes (Color.to_bytes e.color)
let to_string e = subject e ^ ": " ^ Reason.of_ray Film.default e

(* {1 Pixels} *)

let pixel_subject { Explain.x; y; film; color; _ } =
  Printf.sprintf "pixel (%d, %d) is %s" x y (bytes (Film.to_bytes film color))

let verb n = if n = 1 then "sees" else "see"

let first_clause count group =
  let n = Group.size group in
  if n = count then
    Printf.sprintf "all %d samples see %s" count group.Group.sees
  else Printf.sprintf "%d of %d samples %s %s" n count (verb n) group.sees

let clause group =
  let n = Group.size group in
  Printf.sprintf "%d %s %s" n (verb n) group.Group.sees

let most = 4

let others groups =
  match List.filteri (fun k _ -> k >= most) groups with
  | [] -> []
  | rest ->
      let n =
        List.fold_left (fun sum group -> sum + Group.size group) 0 rest
      in
      [ Printf.sprintf "%d %s something else" n (verb n) ]

let over_exposed { Explain.film; samples; _ } =
  let is_over { Explain.ray; _ } = Film.over_exposed film ray.color in
  match List.length (List.filter is_over samples) with
  | 0 -> []
  | n when n = List.length samples -> [ "all are over-exposed" ]
  | n -> [ Printf.sprintf "%d of them over-exposed" n ]

let pixel_reason (pixel : Explain.pixel) =
  match (pixel.samples, Group.of_pixel pixel) with
  | [ { ray; _ } ], _ -> Reason.of_ray pixel.film ray
  | samples, (first :: rest as groups) ->
      let told = List.filteri (fun k _ -> k < most - 1) rest in
      String.concat "; "
        ((first_clause (List.length samples) first :: List.map clause told)
        @ others groups @ over_exposed pixel)
  | _, [] -> ""

let of_pixel pixel = pixel_subject pixel ^ ": " ^ pixel_reason pixel
