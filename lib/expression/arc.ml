open Exact

(* A half turn over pi, in degrees: 26 bits of it, what is left, and all. *)
let degree_high = 0x1.ca5dc18p+5
let degree_low = 0x1.31e0fbdc30a97p-22
let degree = 0x1.ca5dc1a63c1f8p+5

(* base + sign * atan ((a + da) / (b + db)), in degrees, where 0 <= a <= b.
   atan (a / b) = atan c + atan ((a - c b) / (b + c a)), and with c the nearest
   sixteenth, whose arc is in a table, the series of the other needs six
   terms. *)
let[@inline] from base sign a da b db =
  let q = a /. b in
  if not (q >= 0x1p-200) then
    (* larger if need be, so that nothing is lost before the quotient *)
    let unit = if b < 1. then 0x1p100 else 1. in
    mul_add sign (a *. unit *. degree /. (b *. unit)) base
  else
    let place = int_of_float (mul_add q 16. 0.5) in
    let c = float_of_int place /. 16. in
    let a_high = head a and b_high = head b in
    let a_low = a -. a_high +. da and b_low = b -. b_high +. db in
    let over = sub_mul a c b_high and d_over = sub_mul da c b_low in
    let under = mul_add c a b in
    let under_high = head under in
    let under_low = mul_add c a_high (b -. under_high) +. mul_add c a_low db in
    let t = head ((over +. d_over) /. under) in
    let left = sub_mul over t under_high +. sub_mul d_over t under_low in
    let dt = left /. under in
    let all = t +. dt in
    let z = all *. all in
    let p = mul_add z (1. /. 13.) (-1. /. 11.) in
    let p = mul_add z p (1. /. 9.) in
    let p = mul_add z p (-1. /. 7.) in
    let p = mul_add z p (1. /. 5.) in
    let p = mul_add z p (-1. /. 3.) in
    let rest = mul_add (all *. z) p dt in
    let known = mul_add sign Arc_table.high.(place) base in
    let main = sign *. (t *. degree_high) in
    let sum = known +. main in
    let low =
      mul_add t degree_low (mul_add rest degree Arc_table.low.(place))
    in
    sum +. mul_add sign low (main -. (sum -. known))

(* atan2 of y + dy and x + dx, neither of which is very large or small *)
let[@inline] turn y dy x dx =
  let far = abs_float x in
  let d_far = if x < 0. then -.dx else dx in
  let steep = y > far in
  let base = if steep then 90. else if x < 0. then 180. else 0. in
  let sign = if steep = (x < 0.) then 1. else -1. in
  let a = if steep then far else y and b = if steep then y else far in
  let da = if steep then d_far else dy and db = if steep then dy else d_far in
  from base sign a da b db

let[@inline] with_sign_of y angle = if y < 0. then -.angle else angle

let[@inline] atan2 y x =
  let up = abs_float y in
  let size = abs_float x +. up in
  if size = 0. then 0.
  else
    let unit =
      if size > 0x1p900 then 0x1p-100
      else if size < 0x1p-700 then 0x1p300
      else 1.
    in
    with_sign_of y (turn (up *. unit) 0. (x *. unit) 0.)

let[@inline] atan x = atan2 x 1.

(* The bound for what is a little beyond it, NaN for what is far. *)
let[@inline] within_bounds x =
  if abs_float x <= 1. then x
  else if abs_float x <= 1. +. 1e-9 then if x > 0. then 1. else -1.
  else nan

(* 1 - x^2 and what it lacks; the square is that of the two parts of x *)
let[@inline] complement x =
  let square = x *. x in
  1. -. square

let[@inline] complement_lack x =
  let square = x *. x in
  let high = head x in
  let low = x -. high in
  let lost = sub_mul square high high in
  let lost = sub_mul lost (2. *. high) low in
  let lost = sub_mul lost low low in
  1. -. complement x -. square +. lost

let[@inline] root_lack w dw root =
  let high = head root in
  let low = root -. high in
  let left = sub_mul w high high in
  let left = sub_mul left (2. *. high) low in
  let left = sub_mul left low low in
  if root = 0. then 0. else (left +. dw) /. (2. *. root)

let[@inline] asin x =
  let x = within_bounds x in
  let w = complement x in
  let root = sqrt w in
  let lack = root_lack w (complement_lack x) root in
  with_sign_of x (turn (abs_float x) 0. root lack)

let[@inline] acos x =
  let x = within_bounds x in
  let w = complement x in
  let root = sqrt w in
  turn root (root_lack w (complement_lack x) root) x 0.
