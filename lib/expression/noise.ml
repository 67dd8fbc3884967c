open Exact

(* The lattice begins again after 2^30, which nobody sees: so that its numbers
   are ints on every platform. *)
let[@inline] wrap x =
  if abs_float x < 0x1p29 then x
  else sub_mul x 0x1p30 (floor ((x /. 0x1p30) +. 0.5))

(* Where the lattice lies. In its corners the noise is 0: no point that somebody
   writes, of whole coordinates for example, should be one. *)
let shift_x = 0.354
let shift_y = 0.618
let shift_z = 0.236

let[@inline] cell x =
  let i = int_of_float x in
  if float_of_int i > x then i - 1 else i

let[@inline] fade t =
  let p = mul_add t 6. (-15.) in
  let p = mul_add t p 10. in
  t *. t *. t *. p

let[@inline] between t a b = mul_add t (b -. a) a

(* The twelve directions from the centre of a cube to its edges. *)
let along_x = [| 1.; -1.; 1.; -1.; 1.; -1.; 1.; -1.; 0.; 0.; 0.; 0. |]
let along_y = [| 1.; 1.; -1.; -1.; 0.; 0.; 0.; 0.; 1.; -1.; 1.; -1. |]
let along_z = [| 0.; 0.; 0.; 0.; 1.; 1.; -1.; -1.; 1.; 1.; -1.; -1. |]

(* The product of the direction at a corner, h, with the way from there. *)
let[@inline] slope h x y z =
  let d = Hash.pick 12 (Hash.stir h) in
  mul_add along_z.(d) z (mul_add along_y.(d) y (along_x.(d) *. x))

(* What the sum is at most, wherever in a cell, with the worst of directions. *)
let largest = 1.036353812

(* The noise of one of many lattices. A corner is a number: that of its plane,
   then that with its row, then that with its place in the row. *)
let[@inline] layer seed x y z =
  let x = wrap x +. shift_x
  and y = wrap y +. shift_y
  and z = wrap z +. shift_z in
  let i = cell x and j = cell y and k = cell z in
  let x = x -. float_of_int i
  and y = y -. float_of_int j
  and z = z -. float_of_int k in
  let u = fade x and v = fade y and w = fade z in
  let h0 = Hash.stir (seed + i) and h1 = Hash.stir (seed + i + 1) in
  let h00 = Hash.stir (h0 + j) + k and h01 = Hash.stir (h0 + j + 1) + k in
  let h10 = Hash.stir (h1 + j) + k and h11 = Hash.stir (h1 + j + 1) + k in
  let x' = x -. 1. and y' = y -. 1. and z' = z -. 1. in
  let a = between u (slope h00 x y z) (slope h10 x' y z) in
  let b = between u (slope h01 x y' z) (slope h11 x' y' z) in
  let near = between v a b in
  let a = between u (slope (h00 + 1) x y z') (slope (h10 + 1) x' y z') in
  let b = between u (slope (h01 + 1) x y' z') (slope (h11 + 1) x' y' z') in
  let far = between v a b in
  between w near far /. largest

let[@inline] noise x y z = layer 0 x y z

let[@inline] turbulence x y z octaves =
  let x = ref x and y = ref y and z = ref z in
  let sum = ref 0. and weight = ref 1. and all = ref 0. in
  for octave = 0 to Int.min octaves 32 - 1 do
    let layer = layer (Hash.mix octave) !x !y !z in
    sum := mul_add !weight layer !sum;
    all := !all +. !weight;
    weight := 0.5 *. !weight;
    x := 2. *. wrap !x;
    y := 2. *. wrap !y;
    z := 2. *. wrap !z
  done;
  if !all > 0. then !sum /. !all else 0.
