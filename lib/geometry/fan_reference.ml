(* 13 bits of depth, 25 of place, and 8 each of u, v and radius *)
let depth_shift = 49
let place_shift = 24
let place_mask = 0x1ffffff
let most_places = place_mask
let slices = 1 lsl 13
let units = 64
let fine = float_of_int units

(* Middles of discs may lie up to this far outside of the cell. *)
let margin = 96
let far = 0x3fffffff
let unknown_disc = (128 lsl 16) lor (128 lsl 8) lor 255

(* A little farther than where it is, by more than roundings. *)
let beyond d =
  if d < float_of_int (slices - 4) then (int_of_float d + 2) lsl depth_shift
  else max_int

(* Middle and point are each rounded by at most a half along u and v, so that
   they are at most sqrt 2 farther apart than it seems. *)
let disc u v radius =
  let u = u + margin and v = v + margin in
  if u lor v land lnot 255 = 0 && radius < 250. then
    (u lsl 16) lor (v lsl 8) lor int_of_float (radius +. 2.42)
  else unknown_disc

let make ~slice ~place ~u ~v ~radius =
  let slice = if slice > 0. then int_of_float slice else 0 in
  let slice = Int.min slice (slices - 1) in
  (slice lsl depth_shift) lor (place lsl place_shift) lor disc u v radius

let[@inline] place reference = (reference lsr place_shift) land place_mask

let[@inline] may_be_at reference u v =
  let du = ((reference lsr 16) land 255) - margin - u
  and dv = ((reference lsr 8) land 255) - margin - v
  and radius = reference land 255 in
  (du * du) + (dv * dv) <= radius * radius
