open Exact

(* The natural logarithm of 2 in multiples of 2^-42, so that products with
   exponents are exact; a 32nd of it likewise. *)
let ln2_high = 0x1.62e42fefa38p-1
let ln2_low = 0x1.ef35793c7673p-45
let step_high = 0x1.62e42fefap-6
let step_low = 0x1.cf79abc9e3b3ap-45
let steps_per_unit = 0x1.71547652b82fep+5

(* exp (x + dx), for x from -800 to 800: 2^(n / 32) times the exponential of
   the rest, which is less than 0.011, by its series. *)
let[@inline] exp_of_sum x dx =
  let n = nearest (x *. steps_per_unit) in
  let rest = sub_mul x n step_high +. sub_mul dx n step_low in
  let p = mul_add rest (1. /. 5040.) (1. /. 720.) in
  let p = mul_add rest p (1. /. 120.) in
  let p = mul_add rest p (1. /. 24.) in
  let p = mul_add rest p (1. /. 6.) in
  let p = mul_add rest p 0.5 in
  let less_1 = mul_add (rest *. rest) p rest in
  let n = int_of_float n in
  let place = n land 31 in
  let high = Exp_table.high.(place) in
  scale (high +. mul_add high less_1 Exp_table.low.(place)) (n asr 5)

let[@inline] exp x =
  if x > 710. then infinity
  else if x < -746. then 0.
  else if Float.is_nan x then nan
  else exp_of_sum x 0.

(* A finite positive number is 2^[binade] [mantissa], the mantissa between the
   roots of 1/2 and 2; it is [centre], a multiple of 1/64, and [off]. *)
let[@inline] binade x =
  let e = exponent x in
  if scale x (-e) > 0x1.6a09e667f3bcdp+0 then e + 1 else e

let[@inline] place mantissa = int_of_float (mul_add mantissa 64. 0.5)
let[@inline] centre place = float_of_int place /. 64.

(* log x = binade log 2 + log centre + log (mantissa / centre), the last of
   which is 2 (v + v^3 / 3 + ...), v = off / (mantissa + centre) < 0.006. Here
   is the head of v, ... *)
let[@inline] v_head centre off = head (off /. (centre +. centre +. off))

(* ... here what is left of it, ... *)
let[@inline] v_rest centre off v =
  let sum = centre +. centre +. off in
  let high = head sum in
  let low = off -. (high -. centre -. centre) in
  let left = sub_mul off v high in
  sub_mul left v low /. sum

(* ... here that and the series after it, ... *)
let[@inline] v_rest_and_series centre off v =
  let rest = v_rest centre off v in
  let v = v +. rest in
  let z = v *. v in
  let p = mul_add z (1. /. 9.) (1. /. 7.) in
  let p = mul_add z p (1. /. 5.) in
  let p = mul_add z p (1. /. 3.) in
  mul_add (v *. z) p rest

(* ... and the sum, as a double and what it lacks. *)
let[@inline] known binade place =
  mul_add binade ln2_high Log_table.high.(place - Log_table.first)

let[@inline] log_main binade place off =
  mul_add 2. (v_head (centre place) off) (known binade place)

let[@inline] log_lack binade place off main =
  let centre = centre place in
  let v = v_head centre off in
  let low = mul_add binade ln2_low Log_table.low.(place - Log_table.first) in
  let low = mul_add 2. (v_rest_and_series centre off v) low in
  let lost = mul_add 2. v (known binade place -. main) in
  lost +. low

let[@inline] log x =
  if x > 0. && x < infinity then
    let binade = binade x in
    let mantissa = scale x (-binade) in
    let place = place mantissa in
    let off = mantissa -. centre place in
    let binade = float_of_int binade in
    let main = log_main binade place off in
    main +. log_lack binade place off main
  else if x = 0. then neg_infinity
  else if x > 0. then infinity
  else nan

(* x^y for positive x *)
let[@inline] of_positive x y =
  let binade = binade x in
  let mantissa = scale x (-binade) in
  let place = place mantissa in
  let off = mantissa -. centre place in
  let binade = float_of_int binade in
  let main = log_main binade place off in
  let lack = log_lack binade place off main in
  let log = main +. lack in
  let size = y *. log in
  if size > 710. then infinity
  else if size < -746. then 0.
  else if Float.is_nan size then nan
  else
    let d_log = lack -. (log -. main) in
    let log_high = head log and y_high = head y in
    let d_size = sub_mul (-.size) (-.y_high) log_high in
    let d_size = mul_add y_high (log -. log_high) d_size in
    let d_size = mul_add (y -. y_high) log d_size in
    exp_of_sum size (mul_add y d_log d_size)

let[@inline] whole y = floor y = y
let[@inline] odd y = whole y && not (whole (0.5 *. y))

let[@inline] pow x y =
  let size = abs_float x in
  if y = 0. || x = 1. then 1.
  else if y = 2. then x *. x
  else if size > 0. && size < infinity then
    let result = of_positive size y in
    if x > 0. then result
    else if not (whole y) then nan
    else if odd y then -.result
    else result
  else if Float.is_nan (x +. y) || x < 0. then nan
  else
    let of_zero = x = 0. and positive = y > 0. in
    if of_zero = positive then 0. else infinity
