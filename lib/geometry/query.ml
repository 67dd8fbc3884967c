type t = { nearest : Ray.t -> int; blocked : Ray.t -> bool }

let no_shape = -1

let brute_force shapes =
  let nearest (ray : Ray.t) =
    let best = ref no_shape and limit = ref ray.reach in
    Array.iteri
      (fun number shape ->
        let t = Shape.nearest shape ray in
        if t < !limit then (
          best := number;
          limit := t))
      shapes;
    !best
  and blocked (ray : Ray.t) =
    Array.exists (fun shape -> Shape.nearest shape ray < ray.reach) shapes
  in
  { nearest; blocked }
