open Raylab_geometry
open Raylab_expression

type t = { corner : Vec3.t; edge : Vec3.t; other : Vec3.t; count : int }

let max_count = 64

let corners { corner; edge; other; _ } =
  let open Vec3.Infix in
  [ corner; corner + edge; corner + edge + other; corner + other ]

let make ~corner ~edge ~other ~count =
  let pane = { corner; edge; other; count } in
  if count < 1 || count > max_count then
    invalid_arg
      (Printf.sprintf "the points along an edge must be from 1 to %d, not %d"
         max_count count);
  if not (List.for_all Vec3.is_finite (edge :: other :: corners pane)) then
    invalid_arg "the corners of an area light must be finite";
  pane

let points { count; _ } = count * count

(* The golden ratio less 1: its multiples are spread evenly, however many. *)
let golden = 0x1.3c6ef372fe95p-1
let mask = 0x3FFFFFFF

let[@inline] random seed salt =
  let h = Hash.mix (Hash.mix (int_of_float seed land mask) lxor salt) in
  (float_of_int h +. 0.5) *. 0x1p-30

let[@inline] fraction x = x -. float_of_int (int_of_float x)

let[@inline] place count cell beside shift =
  let within = fraction (shift +. (float_of_int beside *. golden)) in
  (float_of_int cell +. within) /. float_of_int count

let[@inline] across { count; _ } k ~seed =
  place count (k / count) (k mod count) (random seed 6)

let[@inline] along { count; _ } k ~seed =
  place count (k mod count) (k / count) (random seed 7)

let transformed ~point ~vector { corner; edge; other; count } =
  make ~corner:(point corner) ~edge:(vector edge) ~other:(vector other) ~count

let equal a b =
  Vec3.equal a.corner b.corner
  && Vec3.equal a.edge b.edge && Vec3.equal a.other b.other
  && a.count = b.count
