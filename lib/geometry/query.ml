type t = { nearest : Raw_ray.t -> int; blocked : int -> Raw_ray.t -> bool }
type index = unit -> t

let no_shape = -1

let brute_force shapes () =
  let nearest (ray : Raw_ray.t) =
    let best = ref no_shape in
    Array.iteri
      (fun number shape ->
        let t = Shape.nearest_raw shape ray in
        if t < ray.reach then (
          best := number;
          ray.reach <- t))
      shapes;
    !best
  and blocked _ (ray : Raw_ray.t) =
    Array.exists (fun shape -> Shape.nearest_raw shape ray < ray.reach) shapes
  in
  { nearest; blocked }
