type t = { mutable number : int; mutable part : int }

let none = -1
let create () = { number = none; part = 0 }
let[@inline] clear meeting = meeting.number <- none
let[@inline] is_none meeting = meeting.number = none

let[@inline] offer meeting (ray : Raw_ray.t) ~number ~part t =
  (* false for NaN *)
  if t <= ray.reach && t > 0. && (t < ray.reach || number < meeting.number)
  then (
    ray.reach <- t;
    meeting.number <- number;
    meeting.part <- part)
