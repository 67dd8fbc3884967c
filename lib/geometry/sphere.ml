type t = { cx : float; cy : float; cz : float; radius : float }

let make ~(centre : Vec3.t) ~radius =
  Number.require Finite "the x of the centre" centre.x;
  Number.require Finite "the y of the centre" centre.y;
  Number.require Finite "the z of the centre" centre.z;
  Number.require Positive "the radius" radius;
  { cx = centre.x; cy = centre.y; cz = centre.z; radius }

let centre s = Vec3.make s.cx s.cy s.cz

(* [roots s ray none found] is [found near far] with the two distances at
   which the line meets the sphere, or [none]. *)
let[@inline] roots s (ray : Ray.t) none found =
  let fx = s.cx -. ray.ox and fy = s.cy -. ray.oy and fz = s.cz -. ray.oz in
  let along = (fx *. ray.dx) +. (fy *. ray.dy) +. (fz *. ray.dz) in
  let lx = fx -. (along *. ray.dx)
  and ly = fy -. (along *. ray.dy)
  and lz = fz -. (along *. ray.dz) in
  let discriminant =
    (s.radius *. s.radius) -. ((lx *. lx) +. (ly *. ly) +. (lz *. lz))
  in
  (* false for NaN *)
  if discriminant >= 0. then
    let half = sqrt discriminant in
    found (along -. half) (along +. half)
  else none

let intersections s ray = roots s ray [] (fun near far -> [ near; far ])

let nearest s ray =
  roots s ray infinity (fun near far ->
      if near > 0. then near else if far > 0. then far else infinity)

let y_axis = Direction.of_vec3_exn (Vec3.make 0. 1. 0.)
let normal s point = Direction.of_vec3_or y_axis (Vec3.sub point (centre s))

let project s normal =
  Vec3.add (centre s) (Vec3.scale s.radius (normal : Direction.t :> Vec3.t))
