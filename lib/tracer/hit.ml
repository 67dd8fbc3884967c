open Raylab_geometry

type t = { t : float; point : Vec3.t; normal : Direction.t; offset : float }

(* A computed point lies within a few units in the last place (2^-52 each) of
   the largest number that went into it; this leaves some room. *)
let rounding = 0x1p-44

let make ~offset shape ray =
  let t = Shape.nearest shape ray in
  let reached = Ray.at ray t in
  let outward = Shape.normal shape reached in
  (* The sum o + t d carries the rounding errors of o and t; the point of the
     sphere nearest to it only those of the sphere itself. *)
  let point, size =
    match shape with
    | Sphere s -> (Sphere.project s outward, s.radius)
    | Plane _ -> (reached, 0.)
  in
  let size = size +. Vec3.magnitude point +. Vec3.magnitude (Ray.origin ray) in
  let same_way =
    Vec3.dot (outward :> Vec3.t) (Ray.direction ray :> Vec3.t) > 0.
  in
  {
    t;
    point;
    normal = (if same_way then Direction.neg outward else outward);
    offset = Float.max offset (rounding *. size);
  }

let start hit =
  Vec3.add hit.point (Vec3.scale hit.offset (hit.normal :> Vec3.t))

let pp ppf hit =
  Format.fprintf ppf "t = %a at %a, normal %a" Number.pp hit.t Vec3.pp hit.point
    Direction.pp hit.normal
