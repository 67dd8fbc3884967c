type t = {
  nearest : Raw_ray.t -> Meeting.t -> unit;
  blocked : int -> Raw_ray.t -> bool;
}
