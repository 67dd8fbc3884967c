(* How well the points of an area light are placed, as a table for SAMPLES.md:

   dune exec --profile release test/bench/panes.exe *)

open Raylab_geometry
open Raylab_expression
open Raylab_scene

type placing = { name : string; points : int -> int -> (float * float) list }
(** [points n seed] is the places of n x n points, from 0 to 1. *)

let hash seed n = Hash.mix (Hash.mix n lxor seed)
let unit h = (float_of_int h +. 0.5) /. 0x1p30

let cells n =
  List.concat (List.init n (fun i -> List.init n (fun j -> (i, j))))

let in_cells n within =
  let place cell x = (float_of_int cell +. x) /. float_of_int n in
  List.map
    (fun (i, j) ->
      let u, v = within i j in
      (place i u, place j v))
    (cells n)

let middle n _ = in_cells n (fun _ _ -> (0.5, 0.5))

let jittered n seed =
  in_cells n (fun i j ->
      let k = (2 * ((i * n) + j)) + 8 in
      (unit (hash seed k), unit (hash seed (k + 1))))

let shifted n seed =
  let u = unit (hash seed 6) and v = unit (hash seed 7) in
  in_cells n (fun _ _ -> (u, v))

(* 0, ..., n - 1 in an order that looks random. *)
let shuffled n seed =
  let keyed = List.init n (fun k -> (hash seed (k + 100), k)) in
  Array.of_list (List.map snd (List.sort compare keyed))

(* A. Kensler, Correlated multi-jittered sampling, 2013 *)
let multi_jittered n seed =
  let p = shuffled n (hash seed 1) and q = shuffled n (hash seed 2) in
  let part k x = (float_of_int k +. x) /. float_of_int n in
  in_cells n (fun i j ->
      let k = (2 * ((i * n) + j)) + 8 in
      (part p.(j) (unit (hash seed k)), part q.(i) (unit (hash seed (k + 1)))))

let ours n seed =
  let axis x y z = Vec3.make x y z and seed = float_of_int seed in
  let pane =
    Pane.make ~corner:Vec3.zero ~edge:(axis 1. 0. 0.) ~other:(axis 0. 1. 0.)
      ~count:n
  in
  List.init (n * n) (fun k ->
      (Pane.across pane k ~seed, Pane.along pane k ~seed))

let placings =
  [
    { name = "the middle"; points = middle };
    { name = "anywhere in the cell"; points = jittered };
    { name = "the same place in all cells"; points = shifted };
    { name = "correlated multi-jittered"; points = multi_jittered };
    { name = "**multiples of the golden ratio**"; points = ours };
  ]

(* {1 Shadows}

   A point of the light is seen if the shape, moved by d from 0 to 1, does not
   hide it. *)

let edge degrees d (u, v) =
  let c = Degrees.cos degrees and s = Degrees.sin degrees in
  (u *. c) +. (v *. s) > d *. (c +. s)

let disc d (u, v) = Float.hypot (u -. 0.2) (v -. 0.3) > d

let shadows =
  [
    ("along an edge", edge 0.); ("10°", edge 10.); ("30°", edge 30.);
    ("45°", edge 45.); ("a disc", disc);
  ]
[@@ocamlformat "disable"]

let mean xs = List.fold_left ( +. ) 0. xs /. float_of_int (List.length xs)

let part seen points =
  mean (List.map (fun p -> if seen p then 1. else 0.) points)

let positions = List.init 24 (fun k -> (float_of_int k +. 0.5) /. 24.)

(* The root of the mean squared error in levels, of so many samples each. *)
let error placing n shadow samples =
  let squared d =
    let seen = shadow d in
    let exact = part seen (middle 200 0) in
    let pixel k =
      let sample s = part seen (placing.points n ((k * samples) + s)) in
      (mean (List.init samples sample) -. exact) ** 2.
    in
    mean (List.init 40 pixel)
  in
  255. *. sqrt (mean (List.map squared positions))

let () =
  let n = 4 in
  List.iter
    (fun placing ->
      Printf.printf "| %s |" placing.name;
      List.iter
        (fun (_, shadow) ->
          Printf.printf " %.1f / %.1f |" (error placing n shadow 1)
            (error placing n shadow 16))
        shadows;
      print_newline ())
    placings
