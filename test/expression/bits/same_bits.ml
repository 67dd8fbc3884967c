(* Prints a checksum of the bits of 100,000 results of each function, which are
   to be the same wherever this runs. *)

open Raylab_expression

let count = 100_000
let mask = 0x3FFFFFFF

(* Numbers of 30 bits that look random. What is compared must not depend on more
   than ints and arithmetic, as the standard library's do. *)
let next state =
  state := Hash.mix (!state + 0x1E3779B9) land mask;
  !state

let unit state = float_of_int (next state) /. 0x1p30
let uniform a b state = Exact.mul_add (b -. a) (unit state) a

(* of any exponent and either sign, NaN and infinities sometimes *)
let any state =
  let sign = if next state land 1 = 0 then 1. else -1. in
  match next state land 63 with
  | 0 -> nan
  | 1 -> sign *. infinity
  | 2 -> sign *. 0.
  | 3 -> sign
  | _ ->
      let mantissa = Exact.mul_add (unit state) 0x1p-30 (1. +. unit state) in
      sign *. Exact.scale mantissa ((next state mod 2098) - 1074)

(* near 1, above and below *)
let near_1 state = 1. +. Exact.scale (unit state -. 0.5) (-(next state mod 53))
let some choices state = choices.(next state mod Array.length choices) state

let add checksum number =
  let bits = if Float.is_nan number then 1L else Int64.bits_of_float number in
  let part sum shift =
    let bits = Int64.shift_right_logical bits shift in
    Hash.mix (sum lxor (Int64.to_int bits land 0xFFFF))
  in
  List.fold_left part checksum [ 0; 16; 32; 48 ]

let show name result =
  let state = ref 1 and checksum = ref 0 in
  for _ = 1 to count do
    checksum := add !checksum (result state)
  done;
  Printf.printf "%-11s %08x\n" name !checksum

let of_one name f source = show name (fun state -> f (source state))

let of_two name f a b =
  show name (fun state ->
      let x = a state in
      f x (b state))

let of_three name f source =
  show name (fun state ->
      let x = source state in
      let y = source state in
      f x y (source state))

let angles = some [| uniform (-45.) 45.; uniform (-1e6) 1e6; any |]
let sines = some [| uniform (-1.) 1.; near_1; any |]
let reals = some [| uniform (-2.) 2.; uniform (-1e3) 1e3; any |]
let positive = some [| uniform 0. 10.; near_1; any |]

let () =
  of_one "sin" Degrees.sin angles;
  of_one "cos" Degrees.cos angles;
  of_one "tan" Degrees.tan angles;
  of_one "asin" Arc.asin sines;
  of_one "acos" Arc.acos sines;
  of_one "atan" Arc.atan reals;
  of_two "atan2" Arc.atan2 reals reals;
  of_one "exp" Power.exp
    (some [| uniform (-1.) 1.; uniform (-750.) 715.; any |]);
  of_one "log" Power.log positive;
  of_two "pow" Power.pow positive reals;
  of_two "modulo" Range.modulo reals reals;
  of_three "mix" Range.mix reals;
  of_three "smoothstep" Range.smoothstep reals;
  of_one "random" Hash.random reals;
  of_three "noise" Noise.noise reals;
  of_three "turbulence" (fun x y z -> Noise.turbulence x y z 5) reals;
  of_one "hsv"
    (fun h ->
      let color = Hsv.color ~h ~s:0.7 ~v:0.9 in
      color.x +. color.y -. color.z)
    angles
