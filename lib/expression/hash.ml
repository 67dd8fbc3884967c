open Exact

(* 30 bits: what an int has on every platform without a sign. *)
let mask = 0x3FFFFFFF

(* Odd, or numbers would become the same. Those of mix were searched for: no
   others of some thousands tried came nearer to a half; see its test. *)
let multiplier = 0x1F7EF349
let second_multiplier = 0x05CC5351

(* Makes the higher bits depend on the lower ones, ... *)
let[@inline] times h multiplier = h * multiplier land mask

(* ... and the lower bits on the higher ones. *)
let[@inline] fold h shift = h lxor (h lsr shift)
let[@inline] stir h = fold (times h multiplier) 15

let[@inline] pick n h =
  let upper_half = times h second_multiplier lsr 15 in
  (upper_half * n) lsr 15

let[@inline] mix h =
  let h = times (fold h 15) multiplier in
  let h = times (fold h 12) second_multiplier in
  fold h 15

(* The halves of the 53 bits of a number at least 1 and less than 2. *)
let[@inline] upper mantissa = int_of_float (mantissa *. 0x1p26)

let[@inline] lower mantissa upper =
  let rest = mantissa -. (float_of_int upper /. 0x1p26) in
  int_of_float (rest *. 0x1p52)

let[@inline] random k =
  let size = abs_float k in
  if size <= max_float then
    let e = if size = 0. then 0 else exponent size in
    let mantissa = scale size (-e) in
    let upper = upper mantissa in
    let lower = lower mantissa upper in
    (* the exponents begin at -1074 *)
    let rank = (2 * (e + 1075)) + if k < 0. then 1 else 0 in
    let high = mix (mix (mix rank lxor upper) lxor lower) in
    let low = mix (mix (high lxor lower) lxor upper) in
    let sum =
      mul_add (float_of_int (high lsr 4)) 0x1p27 (float_of_int (low lsr 3))
    in
    sum *. 0x1p-53
  else nan
