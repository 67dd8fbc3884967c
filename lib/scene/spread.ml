open Raylab_expression

type t = int

let bits = 16

(* 30 bits are what an int has on every platform without a sign. *)
let mask = 0x3FFFFFFF

(* Of all pixels, also of a picture that takes one sample of each: so it is
   quick. That few pixels far apart have the same does no harm. *)
let[@inline] of_pixel ~x ~y = Hash.mix (Hash.stir x lxor (y land mask))

(* {1 Sobol's sequence} *)

(* The direction numbers of a dimension, for the digits of the number of a
   sample, the lowest first. [initial] is the m of Joe and Kuo, and [polynomial]
   the coefficients of their primitive polynomial, the highest first and without
   those that are always 1. *)
let directions polynomial initial =
  let s = Array.length initial in
  let v = Array.make 12 0 in
  for k = 0 to Array.length v - 1 do
    if k < s then v.(k) <- initial.(k) lsl (bits - 1 - k)
    else (
      v.(k) <- v.(k - s) lxor (v.(k - s) lsr s);
      for i = 1 to s - 1 do
        if polynomial land (1 lsl (s - 1 - i)) <> 0 then
          v.(k) <- v.(k) lxor v.(k - i)
      done)
  done;
  v

(* van der Corput's sequence *)
let first = Array.init 12 (fun k -> 1 lsl (bits - 1 - k))
let second = directions 0 [| 1 |]
let third = directions 1 [| 1; 3 |]
let fourth = directions 1 [| 1; 3; 1 |]

let digits directions k =
  let digits = ref 0 and k = ref k and place = ref 0 in
  while !k > 0 do
    if !k land 1 = 1 then digits := !digits lxor directions.(!place);
    k := !k lsr 1;
    incr place
  done;
  !digits

(* {1 Scrambling} *)

(* The middle of the part that has these digits. *)
let[@inline] coordinate digits = (float_of_int digits +. 0.5) /. 0x1p16
let hash pixel salt = Hash.mix (pixel lxor salt)

(* Digits that turn 0 into a number beside the middle: 1000... or 0111..., and
   then any. *)
let near_middle pixel salt =
  let h = hash pixel salt in
  (if h land 1 = 0 then 0x8000 else 0x7000) lor (h lsr 18)

let is_turned pixel = hash pixel 3 land 1 = 1

let in_pixel pixel directions salt k =
  if k = 0 then 0.5
  else coordinate (digits directions k lxor near_middle pixel salt)

let across pixel k =
  in_pixel pixel (if is_turned pixel then second else first) 1 k

let down pixel k =
  in_pixel pixel (if is_turned pixel then first else second) 2 k

let anywhere pixel directions salt k =
  coordinate (digits directions k lxor (hash pixel salt lsr 14))

let lens pixel k = anywhere pixel third 4 k
let lens' pixel k = anywhere pixel fourth 5 k

(* {1 Seeds} *)

let[@inline] seed pixel k =
  float_of_int (1 + if k = 0 then pixel else hash pixel (k + 8))
