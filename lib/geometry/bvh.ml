open Numbers

type t = {
  tree : Bvh_tree.t;
  endless : Shape.t array;
  endless_numbers : int array;
}

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

let[@inline] endless_distance bvh k ray =
  Shape.nearest_raw (Array.unsafe_get bvh.endless k) ray

let[@inline] leaf_blocks (tree : Bvh_tree.t) place (ray : Raw_ray.t) =
  let s = tree.leaves.spheres and at = 4 * place in
  let radius = s.%(at + 3) in
  if radius < infinity then
    Sphere.nearest_raw s.%(at) s.%(at + 1) s.%(at + 2) radius ray < ray.reach
  else Bvh_leaves.other_distance tree.leaves place ray < ray.reach

(* Goes through the tree, the nearer child of each node first, with the other
   children on [stack]. It narrows the ray's reach to the nearest hit on a
   leaf's shape and is its place among the leaves, or -1. With [any] it stops
   at the first hit that it meets. [endless] is the number of a shape outside
   the tree that is already hit at the end of the reach. [others] is whether
   leaves may have shapes that are no spheres. *)
let[@inline always] descend ~any ~others tree stack endless (ray : Raw_ray.t) =
  let { Bvh_tree.boxes; links; leaves; root } = tree in
  let { Bvh_leaves.spheres; numbers; _ } = leaves in
  let best = ref ray.reach and found = ref (-1) and number = ref endless in
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
  Array.unsafe_set stack 0 Bvh_tree.none;
  let code = ref root and top = ref 0 in
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
    else (
      for place = Bvh_tree.leaf_first !code to Bvh_tree.leaf_last !code do
        let at = 4 * place in
        let x = spheres.%(at) and y = spheres.%(at + 1) in
        let z = spheres.%(at + 2) and radius = spheres.%(at + 3) in
        let middle = Sphere.middle x y z ray in
        let discriminant = Sphere.discriminant x y z radius ray middle in
        (* Nearly all spheres are missed: that is told from hits first. NaN
           may hide another shape, and is no hit on a sphere. *)
        if not (discriminant < 0.) then
          let half = sqrt discriminant in
          let near = middle -. half in
          let t =
            if others && radius = infinity then
              (* the product lets [t] stay in a register *)
              1. *. Bvh_leaves.other_distance leaves place ray
            else if near > 0. then near
            else middle +. half
          in
          let candidate = Array.unsafe_get numbers place in
          if t > 0. && (t < !best || (t = !best && candidate < !number)) then (
            best := t;
            found := place;
            number := candidate)
      done;
      if any && !found >= 0 then code := Bvh_tree.none
      else (
        code := Array.unsafe_get stack !top;
        decr top))
  done;
  ray.reach <- !best;
  !found

(* Apart from the loop for spheres: a call inside that, even one that is never
   made, costs it 3 %. *)

let[@inline never] nearest_of_all tree stack endless ray =
  descend ~any:false ~others:true tree stack endless ray

let[@inline never] any_of_all tree stack ray =
  descend ~any:true ~others:true tree stack Query.no_shape ray

let has_others (tree : Bvh_tree.t) = Array.length tree.leaves.shapes > 0

(* {1 Questions} *)

let nearest bvh stack (ray : Raw_ray.t) =
  let endless = ref Query.no_shape in
  for k = 0 to Array.length bvh.endless - 1 do
    let t = endless_distance bvh k ray in
    if t < ray.reach then (
      ray.reach <- t;
      endless := Array.unsafe_get bvh.endless_numbers k)
  done;
  let place =
    if has_others bvh.tree then nearest_of_all bvh.tree stack !endless ray
    else descend ~any:false ~others:false bvh.tree stack !endless ray
  in
  if place < 0 then !endless else bvh.tree.leaves.numbers.(place)

let rec some_endless_blocks bvh (ray : Raw_ray.t) k =
  k < Array.length bvh.endless
  && (endless_distance bvh k ray < ray.reach
     || some_endless_blocks bvh ray (k + 1))

(* How many series of rays have their last blocker remembered. *)
let max_series = 64

(* Neighbouring points are often in the shadow of the same shape: the one that
   last blocked a ray of the series is asked first. *)
let blocked bvh stack last_blockers series (ray : Raw_ray.t) =
  let series = series land (max_series - 1) in
  let last = last_blockers.(series) in
  (last >= 0 && leaf_blocks bvh.tree last ray)
  || some_endless_blocks bvh ray 0
  ||
  let place =
    if has_others bvh.tree then any_of_all bvh.tree stack ray
    else descend ~any:true ~others:false bvh.tree stack Query.no_shape ray
  in
  if place >= 0 then last_blockers.(series) <- place;
  place >= 0

(* {1 Building} *)

let index ?(domains = 1) ?(quick = true) shapes =
  let is_endless (_, shape) = Option.is_none (Shape.ball shape) in
  let endless = Array.of_seq (Seq.filter is_endless (Array.to_seqi shapes))
  and leaves = Bvh_leaves.of_shapes ~quick shapes in
  let tree = Bvh_tree.build ~domains leaves in
  Bvh_leaves.mark_others ~quick leaves;
  let bvh =
    {
      tree;
      endless = Array.map snd endless;
      endless_numbers = Array.map fst endless;
    }
  in
  fun () ->
    let stack = Array.make (Bvh_tree.max_depth + 1) Bvh_tree.none
    and last_blockers = Array.make max_series (-1) in
    {
      Query.nearest = (fun ray -> nearest bvh stack ray);
      blocked = (fun series ray -> blocked bvh stack last_blockers series ray);
    }
