type t = {
  mutable number : int;
  mutable part : int;
  room : Crossings.t;
  scratch : Scratch.t;
}

let none = -1

let create () =
  {
    number = none;
    part = 0;
    room = Crossings.create ();
    scratch = Scratch.create ();
  }

let[@inline] clear meeting = meeting.number <- none
let[@inline] is_none meeting = meeting.number = none

let[@inline] offer meeting (ray : Raw_ray.t) ~number ~part t =
  (* false for NaN *)
  if
    t <= ray.reach && t > 0.
    && (t < ray.reach || number < meeting.number
       || (number = meeting.number && part < meeting.part))
  then (
    ray.reach <- t;
    meeting.number <- number;
    meeting.part <- part)

let rec offer_from k meeting ray ~number =
  let { Crossings.count; distances; parts; _ } = meeting.room in
  if k < count then
    let t = distances.(k) in
    if t > 0. then offer meeting ray ~number ~part:parts.(k) t
    else offer_from (k + 1) meeting ray ~number

let offer_room meeting ray ~number = offer_from 0 meeting ray ~number
