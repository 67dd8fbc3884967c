type t = {
  nearest : Raw_ray.t -> Meeting.t -> unit;
  blocked : int -> Raw_ray.t -> bool;
}

type index = unit -> t

let brute_force shapes () =
  let offer_all ray meeting =
    Meeting.clear meeting;
    Array.iteri
      (fun number shape -> Shape.offer shape ray meeting ~number)
      shapes
  and blocker = Meeting.create () in
  {
    nearest = offer_all;
    blocked =
      (fun _ ray ->
        offer_all ray blocker;
        not (Meeting.is_none blocker));
  }
