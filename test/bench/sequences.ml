(* How well sequences of samples are spread, as a table for SAMPLES.md:

   dune exec --profile release test/bench/sequences.exe *)

open Raylab_expression
open Raylab_scene

type sequence = { name : string; at : int -> int -> int -> float * float }
(** [at x y k] is where in pixel (x, y) sample [k] is. *)

let frac x = x -. Float.floor x

(* Numbers that look random, one for each pixel and number. *)
let hash x y n = Hash.mix (Hash.mix (Hash.mix n lxor x) lxor y)
let unit h = float_of_int h /. 0x1p30

(* {1 The same in all pixels} *)

let everywhere name point = { name; at = (fun _ _ k -> point k) }
let golden_x = 0.7548776662466927
let golden_y = 0.5698402909980532

let r2 k =
  let k = float_of_int k in
  (frac (0.5 +. (k *. golden_x)), frac (0.5 +. (k *. golden_y)))

let radical base k =
  let rec add k place sum =
    if k = 0 then sum
    else
      let digit = float_of_int (k mod base) in
      add (k / base) (place /. float_of_int base) (sum +. (digit *. place))
  in
  add k (1. /. float_of_int base) 0.

let halton k = (frac (0.5 +. radical 2 k), frac (0.5 +. radical 3 k))
let bits = 16

(* The digits of the two dimensions of a (0, 2)-sequence. *)
let rec sobol k v w =
  if k = 0 then (0, 0)
  else
    let x, y = sobol (k lsr 1) (v lsr 1) (w lxor (w lsr 1)) in
    if k land 1 = 1 then (x lxor v, y lxor w) else (x, y)

let digits k = sobol k (1 lsl (bits - 1)) (1 lsl (bits - 1))
let coordinate digits = (float_of_int digits +. 0.5) /. 0x1p16
let xored (x, y) (a, b) = (coordinate (x lxor a), coordinate (y lxor b))
let centred k = xored (digits k) (0x8000, 0x8000)

(* {1 Another in each pixel} *)

let shifted name point =
  let at x y k =
    let a, b = point k in
    (frac (a +. unit (hash x y 1)), frac (b +. unit (hash x y 2)))
  in
  { name = name ^ ", shifted"; at }

let scrambled x y k = xored (digits k) (hash x y 1 lsr 14, hash x y 2 lsr 14)
let random x y k = (unit (hash x y (2 * k)), unit (hash x y ((2 * k) + 1)))

let jittered count x y k =
  let side = int_of_float (sqrt (float_of_int count)) in
  let a, b = random x y k and cell n = float_of_int n in
  ((cell (k mod side) +. a) /. cell side, (cell (k / side) +. b) /. cell side)

let chosen x y k =
  let pixel = Spread.of_pixel ~x ~y in
  (Spread.across pixel k, Spread.down pixel k)

(* The centre takes the place of the first. *)
let from_centre { name; at } =
  { name; at = (fun x y k -> if k = 0 then (0.5, 0.5) else at x y k) }

let sequences count =
  { name = "jittered grid (known number)"; at = jittered count }
  :: List.map from_centre
       [
         { name = "random"; at = random };
         everywhere "R2 (Roberts 2018)" r2;
         shifted "R2" r2;
         everywhere "Halton (2, 3)" halton;
         shifted "Halton" halton;
         everywhere "(0, 2)" centred;
         { name = "(0, 2), digits scrambled"; at = scrambled };
         { name = "**(0, 2), scrambled beside the centre**"; at = chosen };
       ]

(* {1 Pictures} *)

let side = 96
let width = float_of_int side

let zone_plate x y =
  let x = x /. width and y = y /. width in
  0.5 +. (0.5 *. cos (Float.pi *. width *. ((x *. x) +. (y *. y))))

(* A floor to the horizon, which is at the upper edge. *)
let floor near x y =
  let z = near *. width /. (y +. 2.) in
  (((x /. width) -. 0.5) *. z, z)

let truth holds = if holds then 1. else 0.

let rows x y =
  let x, z = floor 1. x y in
  truth (frac (x *. 6.) < 0.12 || frac (z *. 3.) < 0.1)

let discs x y =
  let x, z = floor 0.6 x y in
  truth (Float.hypot (frac (x *. 5.) -. 0.5) (frac (z *. 5.) -. 0.5) < 0.2)

let edges x y =
  truth
    ((x *. 0.37) +. (y *. 0.93) > 40.
    || Float.hypot (x -. 48.) (y -. 20.) < 13.3)

let pictures =
  [
    ("zone plate", zone_plate);
    ("rows of lines", rows);
    ("discs", discs);
    ("edges", edges);
  ]

(* {1 Errors} *)

let mean picture points x y =
  let add sum (a, b) =
    sum +. picture (float_of_int x +. a) (float_of_int y +. b)
  in
  List.fold_left add 0. points /. float_of_int (List.length points)

let grid =
  let place k = (float_of_int k +. 0.5) /. 48. in
  List.concat_map
    (fun i -> List.init 48 (fun j -> (place i, place j)))
    (List.init 48 Fun.id)

let render sample =
  Array.init (side * side) (fun p -> sample (p mod side) (p / side))

let reference picture = render (mean picture grid)

let root_mean_square errors =
  let add sum e = sum +. (e *. e) in
  let sum = Array.fold_left add 0. errors in
  255. *. sqrt (sum /. float_of_int (Array.length errors))

let blocks errors =
  let across = side / 4 in
  Array.init (across * across) (fun q ->
      let first = (q / across * 4 * side) + (q mod across * 4) in
      let sum = ref 0. in
      for j = 0 to 3 do
        for i = 0 to 3 do
          sum := !sum +. errors.(first + (j * side) + i)
        done
      done;
      !sum /. 16.)

let measure picture truth { at; _ } count =
  let points x y = List.init count (at x y) in
  let seen = render (fun x y -> mean picture (points x y) x y) in
  let errors = Array.map2 ( -. ) seen truth in
  Printf.sprintf "%.1f / %.1f" (root_mean_square errors)
    (root_mean_square (blocks errors))

let () =
  let references = List.map (fun (_, p) -> (p, reference p)) pictures in
  let counts = [ 4; 16; 64 ] in
  let row k =
    let cell (picture, truth) count =
      measure picture truth (List.nth (sequences count) k) count
    in
    let cells =
      List.concat_map (fun p -> List.map (cell p) counts) references
    in
    let { name; _ } = List.nth (sequences 4) k in
    Printf.printf "| %s | %s |\n" name (String.concat " | " cells)
  in
  List.iteri (fun k _ -> row k) (sequences 4)
