type t = { point : Vec3.t; normal : Direction.t }

let make ~(point : Vec3.t) ~normal =
  Number.require Finite "the x of the point" point.x;
  Number.require Finite "the y of the point" point.y;
  Number.require Finite "the z of the point" point.z;
  { point; normal }

(* The distance at which the line meets the plane. For a parallel line it is
   infinite, or NaN if the line lies in the plane. *)
let[@inline] distance { point = p; normal } (ray : Ray.t) =
  let n = (normal :> Vec3.t) in
  let height =
    ((p.x -. ray.ox) *. n.x)
    +. ((p.y -. ray.oy) *. n.y)
    +. ((p.z -. ray.oz) *. n.z)
  and approach = (ray.dx *. n.x) +. (ray.dy *. n.y) +. (ray.dz *. n.z) in
  height /. approach

let intersections plane ray =
  let t = distance plane ray in
  if Float.is_finite t then [ t ] else []

let nearest plane ray =
  let t = distance plane ray in
  (* false for NaN *)
  if t > 0. then t else infinity
