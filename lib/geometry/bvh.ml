type t = {
  tree : Bvh_tree.t;
  planes : float array; (* point and normal: six numbers a plane *)
  plane_numbers : int array;
}

(* The distance at which a ray leaves a box is made larger by this part: more
   than all rounding errors on the way to it (T. Ize, Robust BVH ray traversal,
   JCGT 2013), and far less than a box's size. *)
let slack = 1. +. 0x1p-40

(* Whether a ray misses a box, given the distances at which it enters and leaves
   it on each axis: it does if it leaves on one axis before it enters on
   another, or the box lies behind its origin or beyond [best]. Not 0 if so.

   Each comparison is a number, not a branch: whether a box is missed cannot be
   foretold, and a processor's wrong guess costs as much as ten comparisons. NaN,
   which is 0 times infinity, compares as no miss. *)
let[@inline] misses best in_x in_y in_z out_x out_y out_z =
  in_x > out_y || in_y > out_x || in_x > out_z || in_z > out_x || in_y > out_z
  || in_z > out_y || out_x < 0. || out_y < 0. || out_z < 0. || in_x > best
  || in_y > best || in_z > best

let[@inline] side (boxes : Bvh_tree.boxes) at =
  Bigarray.Array1.unsafe_get boxes at

let slots = 64

let[@inline always] walk ~any bvh stack (ray : Raw_ray.t) =
  let best = ref ray.reach and number = ref Query.no_shape in
  for k = 0 to Array.length bvh.plane_numbers - 1 do
    let p = bvh.planes and at = 6 * k in
    let t =
      Plane.nearest_raw (Array.unsafe_get p at)
        (Array.unsafe_get p (at + 1))
        (Array.unsafe_get p (at + 2))
        (Array.unsafe_get p (at + 3))
        (Array.unsafe_get p (at + 4))
        (Array.unsafe_get p (at + 5))
        ray
    in
    if t < !best then (
      best := t;
      number := if any then max_int else Array.unsafe_get bvh.plane_numbers k)
  done;
  let { Bvh_tree.boxes; links; spheres; numbers; root } = bvh.tree in
  let ox = ray.ox and oy = ray.oy and oz = ray.oz in
  let in_scale_x = 1. /. ray.dx
  and in_scale_y = 1. /. ray.dy
  and in_scale_z = 1. /. ray.dz in
  let out_scale_x = in_scale_x *. slack
  and out_scale_y = in_scale_y *. slack
  and out_scale_z = in_scale_z *. slack in
  let x_in = Bool.to_int (in_scale_x < 0.)
  and y_in = Bool.to_int (in_scale_y < 0.)
  and z_in = Bool.to_int (in_scale_z < 0.) in
  let octant = x_in lor (y_in lsl 1) lor (z_in lsl 2) in
  let x_out = 1 - x_in and y_out = 3 - y_in and z_out = 5 - z_in in
  let y_in = 2 + y_in and z_in = 4 + z_in in
  Array.unsafe_set stack 0 Bvh_tree.none;
  let code = ref (if any && !number >= 0 then Bvh_tree.none else root)
  and top = ref 0 in
  while !code <> Bvh_tree.none do
    if !code < 0 then (
      for place = Bvh_tree.leaf_first !code to Bvh_tree.leaf_last !code do
        let at = 4 * place in
        let t =
          Sphere.nearest_raw
            (Array.unsafe_get spheres at)
            (Array.unsafe_get spheres (at + 1))
            (Array.unsafe_get spheres (at + 2))
            (Array.unsafe_get spheres (at + 3))
            ray
        in
        if t < !best || (t = !best && Array.unsafe_get numbers place < !number)
        then (
          best := t;
          number := if any then place else Array.unsafe_get numbers place)
      done;
      if any && !number >= 0 then code := Bvh_tree.none
      else (
        code := Array.unsafe_get stack !top;
        decr top))
    else
      let node = !code in
      let at = 12 * node in
      let missed =
        misses !best
          ((side boxes (at + x_in) -. ox) *. in_scale_x)
          ((side boxes (at + y_in) -. oy) *. in_scale_y)
          ((side boxes (at + z_in) -. oz) *. in_scale_z)
          ((side boxes (at + x_out) -. ox) *. out_scale_x)
          ((side boxes (at + y_out) -. oy) *. out_scale_y)
          ((side boxes (at + z_out) -. oz) *. out_scale_z)
      and missed' =
        let at = at + 6 in
        misses !best
          ((side boxes (at + x_in) -. ox) *. in_scale_x)
          ((side boxes (at + y_in) -. oy) *. in_scale_y)
          ((side boxes (at + z_in) -. oz) *. in_scale_z)
          ((side boxes (at + x_out) -. ox) *. out_scale_x)
          ((side boxes (at + y_out) -. oy) *. out_scale_y)
          ((side boxes (at + z_out) -. oz) *. out_scale_z)
      in
      let link = 3 * node in
      let first = Array.unsafe_get links link
      and second = Array.unsafe_get links (link + 1) in
      if not missed then
        if not missed' then (
          incr top;
          if (octant lsr Array.unsafe_get links (link + 2)) land 1 = 0 then (
            Array.unsafe_set stack !top second;
            code := first)
          else (
            Array.unsafe_set stack !top first;
            code := second))
        else code := first
      else if not missed' then code := second
      else (
        code := Array.unsafe_get stack !top;
        decr top)
  done;
  ray.reach <- !best;
  !number

let nearest bvh stack ray = walk ~any:false bvh stack ray

let blocked bvh stack blockers slot (ray : Raw_ray.t) =
  let slot = slot land (slots - 1) in
  let last = Array.unsafe_get blockers slot in
  let spheres = bvh.tree.spheres in
  if
    last >= 0
    &&
    let at = 4 * last in
    Sphere.nearest_raw
      (Array.unsafe_get spheres at)
      (Array.unsafe_get spheres (at + 1))
      (Array.unsafe_get spheres (at + 2))
      (Array.unsafe_get spheres (at + 3))
      ray
    < ray.reach
  then true
  else
    let place = walk ~any:true bvh stack ray in
    if place >= 0 && place < max_int then Array.unsafe_set blockers slot place;
    place <> Query.no_shape

let index ?(domains = 1) shapes =
  let spheres = ref [] and planes = ref [] in
  Array.iteri
    (fun number -> function
      | Shape.Sphere s -> spheres := (number, s) :: !spheres
      | Plane p -> planes := (number, p) :: !planes)
    shapes;
  let planes = Array.of_list (List.rev !planes) in
  let flat (_, { Plane.point; normal }) =
    let n = (normal :> Vec3.t) in
    [| point.x; point.y; point.z; n.x; n.y; n.z |]
  in
  let bvh =
    {
      tree = Bvh_tree.build ~domains (Array.of_list (List.rev !spheres));
      planes = Array.concat (Array.to_list (Array.map flat planes));
      plane_numbers = Array.map fst planes;
    }
  in
  fun () ->
    let stack = Array.make (Bvh_tree.max_depth + 1) 0 in
    {
      Query.nearest = (fun ray -> nearest bvh stack ray);
      blocked =
        (let blockers = Array.make slots (-1) in
         fun slot ray -> blocked bvh stack blockers slot ray);
    }
