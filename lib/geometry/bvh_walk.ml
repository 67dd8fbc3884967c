type spheres = { tree : Bvh_tree.t; numbers : int array; rows : float array }

(* The distance at which a ray leaves a box is made larger by this part: more
   than all rounding errors on the way to it (T. Ize, Robust BVH ray traversal,
   JCGT 2013), and far less than a box's size. *)
let slack = 1. +. 0x1p-40

let[@inline] side (boxes : Bvh_tree.boxes) at =
  Bigarray.Array1.unsafe_get boxes at

let[@inline] link_at (links : Bvh_tree.links) at =
  Bigarray.Array1.unsafe_get links at

(* Whether a ray enters the box at [at] nearer than [best]: on no axis does it
   leave the box before it has entered on another, and the box lies neither
   behind the origin nor beyond [best]. [x_in] and [x_out] are the places of the
   sides by which the ray enters and leaves on the x axis, [x_scale] is 1 over
   the direction's x, and [x_scale'] that with [slack].

   Each comparison is written as a rejection, so that NaN, which is 0 times
   infinity, rejects nothing; and it pays to stop at the first. *)
let[@inline always] enters (boxes : Bvh_tree.boxes) at best ox oy oz x_scale
    y_scale z_scale x_scale' y_scale' z_scale' x_in y_in z_in x_out y_out z_out
    =
  let in_x = (side boxes (at + x_in) -. ox) *. x_scale
  and out_x = (side boxes (at + x_out) -. ox) *. x_scale' in
  if in_x > best || out_x < 0. then false
  else
    let in_y = (side boxes (at + y_in) -. oy) *. y_scale
    and out_y = (side boxes (at + y_out) -. oy) *. y_scale' in
    if in_x > out_y || in_y > out_x || in_y > best || out_y < 0. then false
    else
      let in_z = (side boxes (at + z_in) -. oz) *. z_scale
      and out_z = (side boxes (at + z_out) -. oz) *. z_scale' in
      not
        (in_x > out_z || in_z > out_x || in_y > out_z || in_z > out_y
       || in_z > best || out_z < 0.)

(* Lets all spheres of a leaf offer what [ray] meets. *)
let[@inline] offer_spheres { numbers; rows; _ } code ray meeting =
  for place = Bvh_tree.leaf_first code to Bvh_tree.leaf_last code do
    let number = Array.unsafe_get numbers place in
    Sphere.offer_row rows place ray meeting ~number
  done

(* Goes on from the node [code]. Nothing here calls a function that is not inlined: a call, even one that is
   never made, costs the loop 5 %. *)
let descend ~any spheres (walk : Mesh_scratch.t) (ray : Raw_ray.t)
    (meeting : Meeting.t) code =
  let { Bvh_tree.boxes; links; _ } = spheres.tree and stack = walk.stack in
  let ox = ray.ox and oy = ray.oy and oz = ray.oz in
  let x_scale = 1. /. ray.dx
  and y_scale = 1. /. ray.dy
  and z_scale = 1. /. ray.dz in
  let x_scale' = x_scale *. slack
  and y_scale' = y_scale *. slack
  and z_scale' = z_scale *. slack in
  let x_back = Bool.to_int (x_scale < 0.)
  and y_back = Bool.to_int (y_scale < 0.)
  and z_back = Bool.to_int (z_scale < 0.) in
  (* bit k tells whether the ray runs backwards along axis k *)
  let backwards = x_back lor (y_back lsl 1) lor (z_back lsl 2) in
  let x_in = x_back and y_in = 2 + y_back and z_in = 4 + z_back in
  let x_out = 1 - x_back and y_out = 3 - y_back and z_out = 5 - z_back in
  (* A shape may touch its box, where the two distances differ by rounding. *)
  let code = ref code
  and top = ref walk.top
  and best = ref (ray.reach *. slack) in
  let others = ref Bvh_tree.none in
  while !code <> Bvh_tree.none do
    if !code >= 0 then
      let node = !code in
      let at = 12 * node and link = 3 * node in
      let enters_first =
        enters boxes at !best ox oy oz x_scale y_scale z_scale x_scale'
          y_scale' z_scale' x_in y_in z_in x_out y_out z_out
      and enters_second =
        enters boxes (at + 6) !best ox oy oz x_scale y_scale z_scale x_scale'
          y_scale' z_scale' x_in y_in z_in x_out y_out z_out
      in
      if enters_first then
        if enters_second then (
          let first = link_at links link
          and second = link_at links (link + 1) in
          incr top;
          if (backwards lsr link_at links (link + 2)) land 1 = 0 then (
            code := first;
            Array.unsafe_set stack !top second)
          else (
            code := second;
            Array.unsafe_set stack !top first))
        else code := link_at links link
      else if enters_second then code := link_at links (link + 1)
      else (
        code := Array.unsafe_get stack !top;
        decr top)
    else if Bvh_tree.leaf_kind !code = Other then (
      others := !code;
      code := Bvh_tree.none)
    else (
      offer_spheres spheres !code ray meeting;
      best := ray.reach *. slack;
      if any && not (Meeting.is_none meeting) then code := Bvh_tree.none
      else (
        code := Array.unsafe_get stack !top;
        decr top))
  done;
  walk.top <- !top;
  !others

let[@inline] start ~any spheres (walk : Mesh_scratch.t) ray meeting =
  walk.top <- 0;
  descend ~any spheres walk ray meeting spheres.tree.root

let[@inline] go_on ~any spheres (walk : Mesh_scratch.t) ray meeting =
  let code = walk.stack.(walk.top) in
  walk.top <- walk.top - 1;
  descend ~any spheres walk ray meeting code
