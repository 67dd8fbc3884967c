let relative = 1e-5
let of_scale scale = relative *. scale

(* A computed point lies within a few units in the last place (2^-52 each) of
   the largest number that went into it; this leaves some room. *)
let rounding = 0x1p-44
let farthest = 0x1p1022
let farthest_offset = rounding *. farthest

let[@inline] within x =
  if x > farthest then farthest else if x < -.farthest then -.farthest else x

let[@inline] lift ~usual (spot : Spot.t) (ray : Raw_ray.t) =
  let { Spot.x; y; z; own_x; own_y; own_z; size; _ } = spot in
  let least =
    rounding
    *. (size +. abs_float x +. abs_float y +. abs_float z +. abs_float ray.ox
      +. abs_float ray.oy +. abs_float ray.oz)
  in
  if usual >= least then spot.offset <- usual
  else (
    spot.offset <-
      (if least <= farthest_offset then least else farthest_offset);
    Spot.set_point spot (within x) (within y) (within z);
    Spot.set_own spot (within own_x) (within own_y) (within own_z))
