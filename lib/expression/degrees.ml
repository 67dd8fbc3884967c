open Exact

(* A radian is the half turn, in degrees, over pi: here 26 bits of pi / 180,
   what is left of it, and all of it in one. *)
let radian_high = 0x1.1df46ap-6
let radian_low = 0x1.294e9c8ae0ec6p-33
let radian = 0x1.1df46a2529d39p-6

(* The same angle below 2^29, without rounding. A large double is a multiple of
   2^15. To divide it by 2^12, which is 91 * 45 + 1, changes neither its
   remainder by 45 nor that by 8, which is 0, nor hence that by 360. *)
let rec reduce x =
  if abs_float x < 0x1p67 then
    let turns = 360. *. 0x1p20 in
    sub_mul x turns (nearest (x /. turns))
  else if abs_float x <= max_float then reduce (x *. 0x1p-12)
  else nan

(* Up to 2^36 the number of quarter turns is an int on every platform, and 90
   times it is exact. *)
let[@inline] small x = if abs_float x <= 0x1p36 then x else reduce x
let[@inline] quarters x = nearest (x /. 90.)
let[@inline] rest x quarters = sub_mul x 90. quarters
let[@inline] side quarters = int_of_float quarters land 3

(* An angle of at most 45 degrees in radians, [t], and what it lacks, [dt]. *)
let[@inline] minor_part r =
  let high = head r in
  let a = high *. radian_low and b = (r -. high) *. radian in
  a +. b

let[@inline] radians r = mul_add (head r) radian_high (minor_part r)

let[@inline] lack r t =
  let main = head r *. radian_high in
  minor_part r -. (t -. main)

(* Taylor's series, as far as it is told from its sum at 45 degrees. *)

(* sin (t + dt) - t *)
let[@inline] sin_less_t t dt =
  let z = t *. t in
  let p = mul_add z (1. /. 355687428096000.) (-1. /. 1307674368000.) in
  let p = mul_add z p (1. /. 6227020800.) in
  let p = mul_add z p (-1. /. 39916800.) in
  let p = mul_add z p (1. /. 362880.) in
  let p = mul_add z p (-1. /. 5040.) in
  let p = mul_add z p (1. /. 120.) in
  let p = mul_add z p (-1. /. 6.) in
  mul_add (t *. z) p (sub_mul dt (0.5 *. z) dt)

let[@inline] cos_main t =
  let z = t *. t in
  sub_mul 1. 0.5 z

(* cos (t + dt) - cos_main t: the square to twice as many digits, and what is
   after it in the series. *)
let[@inline] cos_less_main t dt =
  let z = t *. t in
  let high = head t in
  let low = t -. high in
  let dz = sub_mul (-.z) (-.high) high in
  let dz = mul_add (2. *. high) low dz in
  let dz = mul_add low low dz in
  let dz = mul_add (2. *. t) dt dz in
  let p = mul_add z (-1. /. 6402373705728000.) (1. /. 20922789888000.) in
  let p = mul_add z p (-1. /. 87178291200.) in
  let p = mul_add z p (1. /. 479001600.) in
  let p = mul_add z p (-1. /. 3628800.) in
  let p = mul_add z p (1. /. 40320.) in
  let p = mul_add z p (-1. /. 720.) in
  let p = mul_add z p (1. /. 24.) in
  let lost = sub_mul (1. -. cos_main t) 0.5 z in
  mul_add (z *. z) p (sub_mul lost 0.5 dz)

let[@inline] sin_small t dt = t +. sin_less_t t dt
let[@inline] cos_small t dt = cos_main t +. cos_less_main t dt

(* The sine of x and as many quarter turns more. *)
let[@inline] sin_ahead x more =
  let x = small x in
  let quarters = quarters x in
  let r = rest x quarters in
  let t = radians r in
  let dt = lack r t in
  match (side quarters + more) land 3 with
  | 0 -> sin_small t dt
  | 1 -> cos_small t dt
  | 2 -> -.sin_small t dt
  | _ -> -.cos_small t dt

let[@inline] sin x = sin_ahead x 0
let[@inline] cos x = sin_ahead x 1

(* (a + da) / (b + db) *)
let[@inline] quotient a da b db =
  let b_high = head b and q = head (a /. b) in
  let left = sub_mul a q b_high in
  let left = sub_mul left q (b -. b_high) in
  let left = left +. sub_mul da q db in
  q +. (left /. b)

let[@inline] tan x =
  let x = small x in
  let quarters = quarters x in
  let r = rest x quarters in
  let t = radians r in
  let dt = lack r t in
  let s = sin_small t dt and c = cos_small t dt in
  let ds = sin_less_t t dt -. (s -. t)
  and dc = cos_less_main t dt -. (c -. cos_main t) in
  if side quarters land 1 = 0 then quotient s ds c dc
  else if r = 0. then infinity
  else -.quotient c dc s ds
