type t = Leaf | Halves | Bins of int * int

let max_bins = 16

(* Few spheres need few bins. *)
let bins_for count = Int.min max_bins (4 + (count / 8))

(* What testing the two boxes of an inner node costs, where testing a sphere
   costs 1. *)
let node_cost = 5.
let depth_of_heuristic = 50
let max_depth = depth_of_heuristic + 40

(* Six numbers, as in a tree's [boxes]. *)
let empty_box (box : float array) at =
  for axis = 0 to 2 do
    box.(at + (2 * axis)) <- infinity;
    box.(at + (2 * axis) + 1) <- neg_infinity
  done

type space = {
  mutable bins : int; (* in use on each axis *)
  counts : int array; (* of each bin of each axis *)
  bounds : float array; (* of the spheres in each bin *)
  centres : float array; (* the box of all centres *)
  scales : float array; (* bins per length, on each axis *)
  areas : float array; (* half the surface of the bins from one on *)
  sweep : float array; (* the box of the bins so far *)
}

let make_space () =
  {
    bins = max_bins;
    counts = Array.make (3 * max_bins) 0;
    bounds = Array.make (3 * max_bins * 6) 0.;
    centres = Array.make 6 0.;
    scales = Array.make 3 0.;
    areas = Array.make max_bins 0.;
    sweep = Array.make 6 0.;
  }

let[@inline] widen (box : float array) at least greatest =
  if least < Array.unsafe_get box at then Array.unsafe_set box at least;
  if greatest > Array.unsafe_get box (at + 1) then
    Array.unsafe_set box (at + 1) greatest

let[@inline] bin_of space axis c =
  let least = Array.unsafe_get space.centres (2 * axis) in
  let k = int_of_float ((c -. least) *. Array.unsafe_get space.scales axis) in
  if k >= space.bins then space.bins - 1 else if k < 0 then 0 else k

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

let[@inline] add_to_bin space bin x y z r =
  Array.unsafe_set space.counts bin (Array.unsafe_get space.counts bin + 1);
  let at = 6 * bin in
  widen space.bounds at (x -. r) (x +. r);
  widen space.bounds (at + 2) (y -. r) (y +. r);
  widen space.bounds (at + 4) (z -. r) (z +. r)

let fill_bins leaves space first stop =
  let bins = space.bins in
  Array.fill space.counts 0 (3 * bins) 0;
  for bin = 0 to (3 * bins) - 1 do
    empty_box space.bounds (6 * bin)
  done;
  for place = first to stop - 1 do
    let x = Bvh_leaves.centre leaves place 0
    and y = Bvh_leaves.centre leaves place 1
    and z = Bvh_leaves.centre leaves place 2
    and r = Bvh_leaves.radius leaves place in
    add_to_bin space (bin_of space 0 x) x y z r;
    add_to_bin space (bins + bin_of space 1 y) x y z r;
    add_to_bin space ((2 * bins) + bin_of space 2 z) x y z r
  done

let widen_by_bin space bin =
  for axis = 0 to 2 do
    let at = (6 * bin) + (2 * axis) in
    widen space.sweep (2 * axis) space.bounds.(at) space.bounds.(at + 1)
  done

let[@inline] half_area (box : float array) =
  let x = box.(1) -. box.(0)
  and y = box.(3) -. box.(2)
  and z = box.(5) -. box.(4) in
  if x < 0. then 0. else (x *. y) +. (y *. z) +. (z *. x)

(* [best_split space count] is the axis and the bin after which the heuristic
   splits [count] spheres, and the cost, relative to the surface of the
   whole. *)
let best_split space =
  let bins = space.bins in
  let best_cost = ref infinity and best = ref None in
  for axis = 0 to 2 do
    if space.scales.(axis) > 0. then (
      empty_box space.sweep 0;
      for k = bins - 1 downto 1 do
        widen_by_bin space ((axis * bins) + k);
        space.areas.(k) <- half_area space.sweep
      done;
      empty_box space.sweep 0;
      let before = ref 0 and total = ref 0 in
      for k = 0 to bins - 1 do
        total := !total + space.counts.((axis * bins) + k)
      done;
      for k = 0 to bins - 2 do
        widen_by_bin space ((axis * bins) + k);
        before := !before + space.counts.((axis * bins) + k);
        let cost =
          (half_area space.sweep *. float_of_int !before)
          +. (space.areas.(k + 1) *. float_of_int (!total - !before))
        in
        if !before > 0 && !before < !total && cost < !best_cost then (
          best_cost := cost;
          best := Some (axis, k))
      done)
  done;
  (!best, !best_cost)

let widen_by_axis space axis first_bin last_bin =
  empty_box space.sweep 0;
  for bin = first_bin to last_bin do
    widen_by_bin space ((axis * space.bins) + bin)
  done

(* Any axis holds all spheres. *)
let whole_area space =
  widen_by_axis space 0 0 (space.bins - 1);
  half_area space.sweep

(* Moves the spheres of the bins up to [last_bin] to the front, and is the place
   where the others start. *)
let partition leaves space axis last_bin first stop =
  let goes_first place =
    bin_of space axis (Bvh_leaves.centre leaves place axis) <= last_bin
  in
  let rec loop low high =
    if low >= high then low
    else if goes_first low then loop (low + 1) high
    else (
      Bvh_leaves.swap leaves low (high - 1);
      loop low (high - 1))
  in
  loop first stop

let box_of_bins space axis first_bin last_bin =
  widen_by_axis space axis first_bin last_bin;
  space.sweep

let box_of_spheres leaves space first stop =
  empty_box space.sweep 0;
  for place = first to stop - 1 do
    let r = Bvh_leaves.radius leaves place in
    for axis = 0 to 2 do
      let c = Bvh_leaves.centre leaves place axis in
      widen space.sweep (2 * axis) (c -. r) (c +. r)
    done
  done;
  space.sweep

let last_bin space = space.bins - 1

let choose leaves space ~max_leaf ~depth first stop =
  let count = stop - first in
  let unless_small = if count <= max_leaf then Leaf else Halves in
  if count = 1 then Leaf
  else if depth >= depth_of_heuristic then unless_small
  else (
    space.bins <- bins_for count;
    measure_centres leaves space first stop;
    fill_bins leaves space first stop;
    match best_split space with
    | None, _ -> unless_small
    | Some (axis, last_bin), cost ->
        let area = whole_area space in
        if
          count <= max_leaf
          && area *. float_of_int count <= (node_cost *. area) +. cost
        then Leaf
        else Bins (axis, last_bin))
