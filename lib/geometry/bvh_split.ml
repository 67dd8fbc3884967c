type t = Leaf | Halves | Kinds | Bins of int

let max_bins = 16

(* Few shapes need few bins. *)
let bins_for count = Int.min max_bins (4 + (count / 8))

(* What testing the two boxes of an inner node costs, where testing a sphere
   costs 1. *)
let node_cost = 5.
let depth_of_heuristic = 50

(* halving ends after 40 levels; a leaf of two kinds is split once more *)
let () = assert (depth_of_heuristic + 41 = Mesh_scratch.max_depth)

(* {1 Boxes}

   Six numbers, as in a tree's [boxes]. *)

let empty_box (box : float array) at =
  for axis = 0 to 2 do
    box.(at + (2 * axis)) <- infinity;
    box.(at + (2 * axis) + 1) <- neg_infinity
  done

let[@inline] widen (box : float array) at least greatest =
  if least < Array.unsafe_get box at then Array.unsafe_set box at least;
  if greatest > Array.unsafe_get box (at + 1) then
    Array.unsafe_set box (at + 1) greatest

let[@inline] widen_by_leaf (box : float array) at leaves place =
  for axis = 0 to 2 do
    widen box
      (at + (2 * axis))
      (Bvh_leaves.side leaves place (2 * axis))
      (Bvh_leaves.side leaves place ((2 * axis) + 1))
  done

let[@inline] half_area (box : float array) =
  let x = box.(1) -. box.(0)
  and y = box.(3) -. box.(2)
  and z = box.(5) -. box.(4) in
  if x < 0. then 0. else (x *. y) +. (y *. z) +. (z *. x)

type space = {
  mutable bins : int; (* in use *)
  mutable axis : int; (* along which they lie *)
  counts : int array; (* of each bin *)
  bounds : float array; (* of what is in each bin *)
  centres : float array; (* the box of all centres *)
  scales : float array; (* bins per length, on each axis *)
  areas : float array; (* half the surface of the bins from one on *)
  sweep : float array; (* the box of the bins so far *)
}

let make_space () =
  {
    bins = max_bins;
    axis = 0;
    counts = Array.make max_bins 0;
    bounds = Array.make (max_bins * 6) 0.;
    centres = Array.make 6 0.;
    scales = Array.make 3 0.;
    areas = Array.make max_bins 0.;
    sweep = Array.make 6 0.;
  }

let axis space = space.axis

let box leaves space first stop =
  empty_box space.sweep 0;
  for place = first to stop - 1 do
    widen_by_leaf space.sweep 0 leaves place
  done;
  space.sweep

(* {1 Bins} *)

(* A scale of 0 says that the centres are not apart on that axis, or so far
   apart that no double tells how far. *)
let measure_centres leaves space first stop =
  empty_box space.centres 0;
  for place = first to stop - 1 do
    for axis = 0 to 2 do
      let c = Bvh_leaves.centre leaves place axis in
      widen space.centres (2 * axis) c c
    done
  done;
  for axis = 0 to 2 do
    let extent = space.centres.((2 * axis) + 1) -. space.centres.(2 * axis) in
    space.scales.(axis) <-
      (if extent > 0. && extent < infinity then
         float_of_int space.bins /. extent
       else 0.)
  done

let[@inline] bin_of leaves space place =
  let axis = space.axis in
  let least = Array.unsafe_get space.centres (2 * axis)
  and c = Bvh_leaves.centre leaves place axis in
  let k = int_of_float ((c -. least) *. Array.unsafe_get space.scales axis) in
  if k >= space.bins then space.bins - 1 else if k < 0 then 0 else k

let fill_bins leaves space first stop =
  Array.fill space.counts 0 space.bins 0;
  for bin = 0 to space.bins - 1 do
    empty_box space.bounds (6 * bin)
  done;
  for place = first to stop - 1 do
    let bin = bin_of leaves space place in
    space.counts.(bin) <- space.counts.(bin) + 1;
    widen_by_leaf space.bounds (6 * bin) leaves place
  done

let widen_by_bin space bin =
  for axis = 0 to 2 do
    let at = (6 * bin) + (2 * axis) in
    widen space.sweep (2 * axis) space.bounds.(at) space.bounds.(at + 1)
  done

type candidate = { axis : int; bin : int; cost : float }
(* [cost] is relative to the surface of the whole *)

(* The better of [best] and the splits between the bins as they are filled. *)
let best_split space count best =
  empty_box space.sweep 0;
  for k = space.bins - 1 downto 1 do
    widen_by_bin space k;
    space.areas.(k) <- half_area space.sweep
  done;
  empty_box space.sweep 0;
  let before = ref 0 and best = ref best in
  for k = 0 to space.bins - 2 do
    widen_by_bin space k;
    before := !before + space.counts.(k);
    let cost =
      (half_area space.sweep *. float_of_int !before)
      +. (space.areas.(k + 1) *. float_of_int (count - !before))
    in
    if !before > 0 && !before < count && cost < !best.cost then
      best := { axis = space.axis; bin = k; cost }
  done;
  !best

let best_of_axes leaves space first stop =
  let best = ref { axis = 0; bin = -1; cost = infinity } in
  for axis = 0 to 2 do
    if space.scales.(axis) > 0. then (
      space.axis <- axis;
      fill_bins leaves space first stop;
      best := best_split space (stop - first) !best)
  done;
  space.axis <- !best.axis;
  !best

(* {1 Splits} *)

let choose leaves space ~max_leaf ~depth first stop =
  let count = stop - first in
  let leaf () =
    if Bvh_leaves.one_kind leaves first stop then Leaf else Kinds
  in
  let unless_small () = if count <= max_leaf then leaf () else Halves in
  if count = 1 then Leaf
  else if depth >= depth_of_heuristic then unless_small ()
  else (
    space.bins <- bins_for count;
    measure_centres leaves space first stop;
    let { bin; cost; _ } = best_of_axes leaves space first stop in
    let area = half_area (box leaves space first stop) in
    if bin < 0 then unless_small ()
    else if
      count <= max_leaf
      && area *. float_of_int count <= (node_cost *. area) +. cost
    then leaf ()
    else Bins bin)

let partition leaves space split first stop =
  match split with
  | Leaf | Halves -> (first + stop) / 2
  | Kinds ->
      let is_sphere place = Bvh_leaves.kind leaves place = Sphere in
      Bvh_leaves.partition leaves is_sphere first stop
  | Bins last_bin ->
      let goes_first place = bin_of leaves space place <= last_bin in
      Bvh_leaves.partition leaves goes_first first stop
