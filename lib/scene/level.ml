(* At 2^52 doubles are the integers, so the sum is rounded to one, ties to
   even, by the processor's default rounding. *)
let[@inline] round_half_even x = x +. 0x1p52 -. 0x1p52

let[@inline] of_channel v =
  if v >= 1. then 255
  else if v > 0. then int_of_float (round_half_even (v *. 255.))
  else 0
