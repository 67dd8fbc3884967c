open Raylab_expression

let exponent = 1. /. 2.4

(* 1 is exact, since 1.055 - 0.055 need not be *)
let encode v =
  if v <= 0.0031308 then 12.92 *. v
  else if v >= 1. then 1.
  else (1.055 *. Power.pow v exponent) -. 0.055
