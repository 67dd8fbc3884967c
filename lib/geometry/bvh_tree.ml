open Bigarray
open Raylab_parallel

type boxes = (float, float64_elt, c_layout) Array1.t
type links = (int, int_elt, c_layout) Array1.t

type t = {
  boxes : boxes;
  links : links;
  spheres : float array;
  numbers : int array;
  root : int;
}

let none = min_int
let max_leaf = 16
let leaf first count = lnot ((first * max_leaf) + count - 1)
let[@inline] leaf_first code = lnot code / max_leaf

let[@inline] leaf_last code =
  let code = lnot code in
  (code / max_leaf) + (code land (max_leaf - 1))

(* {1 Work space} *)

let max_bins = 16

(* Few spheres need few bins. *)
let bins_for count = Int.min max_bins (4 + (count / 8))

(* What testing the two boxes of an inner node costs, where testing a sphere
   costs 1. *)
let node_cost = 5.

(* Below this depth nodes are halved whatever the heuristic says. Halving goes on
   for at most 40 levels more: no array has 2^40 elements. *)
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

let[@inline] centre (spheres : float array) place axis =
  Array.unsafe_get spheres ((4 * place) + axis)

let[@inline] radius (spheres : float array) place =
  Array.unsafe_get spheres ((4 * place) + 3)

let[@inline] bin_of space axis c =
  let least = Array.unsafe_get space.centres (2 * axis) in
  let k = int_of_float ((c -. least) *. Array.unsafe_get space.scales axis) in
  if k >= space.bins then space.bins - 1 else if k < 0 then 0 else k

let measure_centres { spheres; _ } space first stop =
  empty_box space.centres 0;
  for place = first to stop - 1 do
    for axis = 0 to 2 do
      let c = centre spheres place axis in
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

let fill_bins { spheres; _ } space first stop =
  let bins = space.bins in
  Array.fill space.counts 0 (3 * bins) 0;
  for bin = 0 to (3 * bins) - 1 do
    empty_box space.bounds (6 * bin)
  done;
  for place = first to stop - 1 do
    let x = centre spheres place 0
    and y = centre spheres place 1
    and z = centre spheres place 2
    and r = radius spheres place in
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
   splits [count] spheres, and the cost, relative to the surface of the whole. *)
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

let whole_area space =
  empty_box space.sweep 0;
  (* any axis holds all spheres *)
  for k = 0 to space.bins - 1 do
    widen_by_bin space k
  done;
  half_area space.sweep

let swap { spheres; numbers; _ } a b =
  for i = 0 to 3 do
    let kept = spheres.((4 * a) + i) in
    spheres.((4 * a) + i) <- spheres.((4 * b) + i);
    spheres.((4 * b) + i) <- kept
  done;
  let kept = numbers.(a) in
  numbers.(a) <- numbers.(b);
  numbers.(b) <- kept

(* Moves the spheres of the bins up to [last_bin] to the front, and is the place
   where the others start. *)
let partition tree space axis last_bin first stop =
  let goes_first place =
    bin_of space axis (centre tree.spheres place axis) <= last_bin
  in
  let rec loop low high =
    if low >= high then low
    else if goes_first low then loop (low + 1) high
    else (
      swap tree low (high - 1);
      loop low (high - 1))
  in
  loop first stop

(* {1 Boxes} *)

(* A ray that touches a sphere may, by rounding errors, pass its box by a hair. *)
let room least greatest =
  0x1p-30 *. Float.max (abs_float least) (abs_float greatest)

(* Makes [space.sweep] the box of one child of [node]. *)
let write_box tree space node child =
  for axis = 0 to 2 do
    let least = space.sweep.(2 * axis)
    and greatest = space.sweep.((2 * axis) + 1) in
    let room = room least greatest
    and slot = (12 * node) + (6 * child) + (2 * axis) in
    tree.boxes.{slot} <- least -. room;
    tree.boxes.{slot + 1} <- greatest +. room
  done

let write_box_of_bins tree space node child axis first last =
  empty_box space.sweep 0;
  for bin = first to last do
    widen_by_bin space ((axis * space.bins) + bin)
  done;
  write_box tree space node child

let write_box_of_spheres tree space node child first stop =
  empty_box space.sweep 0;
  for place = first to stop - 1 do
    let r = radius tree.spheres place in
    for axis = 0 to 2 do
      let c = centre tree.spheres place axis in
      widen space.sweep (2 * axis) (c -. r) (c +. r)
    done
  done;
  write_box tree space node child

(* {1 Building} *)

type split =
  | Leaf
  | Halves  (** whichever spheres *)
  | Bins of int * int  (** an axis, and the last bin of the first child *)

let find_split tree space first stop depth =
  let count = stop - first in
  let unless_small = if count <= max_leaf then Leaf else Halves in
  if count = 1 then Leaf
  else if depth >= depth_of_heuristic then unless_small
  else (
    space.bins <- bins_for count;
    measure_centres tree space first stop;
    fill_bins tree space first stop;
    match best_split space with
    | None, _ -> unless_small
    | Some (axis, last_bin), cost ->
        let area = whole_area space in
        if
          count <= max_leaf
          && area *. float_of_int count <= (node_cost *. area) +. cost
        then Leaf
        else Bins (axis, last_bin))

(* [divide tree space node split first stop] writes the boxes of the children of
   [node], puts their spheres apart, and is the place where the second child's
   begin. *)
let divide tree space node split first stop =
  match split with
  | Bins (axis, last_bin) ->
      write_box_of_bins tree space node 0 axis 0 last_bin;
      write_box_of_bins tree space node 1 axis (last_bin + 1) (space.bins - 1);
      tree.links.{(3 * node) + 2} <- axis;
      partition tree space axis last_bin first stop
  | Halves | Leaf ->
      let middle = (first + stop) / 2 in
      write_box_of_spheres tree space node 0 first middle;
      write_box_of_spheres tree space node 1 middle stop;
      tree.links.{(3 * node) + 2} <- 0;
      middle

(* A part of the tree that is still to be built: whose child it is, which spheres
   it has, and how deep it lies. *)
type part = { parent : int; first : int; stop : int; depth : int }

(* [grow tree next_node space parts part] builds [part]; parts of at most
   [small] spheres it leaves to [later]. *)
let rec grow tree next_node space ~small later part =
  let { parent; first; stop; depth } = part in
  if stop - first <= small then later part
  else
    let link code = tree.links.{parent} <- code in
    match find_split tree space first stop depth with
    | Leaf -> link (leaf first (stop - first))
    | split ->
        let node = Atomic.fetch_and_add next_node 1 in
        link node;
        let middle = divide tree space node split first stop in
        let child k first stop =
          grow tree next_node space ~small later
            { parent = (3 * node) + k; first; stop; depth = depth + 1 }
        in
        child 0 first middle;
        child 1 middle stop

(* Fewer spheres are not worth another domain's start. *)
let worth_a_domain = 10_000

let grow_all ~domains tree next_node all =
  let count = all.stop - all.first in
  let grow_rest space part = grow tree next_node space ~small:0 ignore part in
  if domains = 1 || count < 2 * worth_a_domain then
    grow_rest (make_space ()) all
  else
    (* the top by one domain, then the parts by all *)
    let parts = ref [] in
    let small = Int.max worth_a_domain (count / (8 * domains)) in
    let later part = parts := part :: !parts in
    grow tree next_node (make_space ()) ~small later all;
    let parts = Array.of_list !parts in
    ignore
      (Parallel.iter ~domains ~worker:make_space ~count:(Array.length parts)
         (fun space k -> grow_rest space parts.(k)))

let store spheres place (s : Sphere.t) =
  spheres.(4 * place) <- s.cx;
  spheres.((4 * place) + 1) <- s.cy;
  spheres.((4 * place) + 2) <- s.cz;
  spheres.((4 * place) + 3) <- s.radius

let build ~domains numbered =
  let count = Array.length numbered in
  let inner = Int.max 0 (count - 1) in
  let root_link = 3 * inner in
  let spheres = Array.make (4 * count) 0. in
  Array.iteri (fun place (_, sphere) -> store spheres place sphere) numbered;
  let tree =
    {
      boxes = Array1.create Float64 C_layout (12 * inner);
      links = Array1.create Int C_layout (root_link + 1);
      spheres;
      numbers = Array.map fst numbered;
      root = none;
    }
  in
  tree.links.{root_link} <- none;
  if count > 0 then
    grow_all ~domains tree (Atomic.make 0)
      { parent = root_link; first = 0; stop = count; depth = 0 };
  { tree with root = tree.links.{root_link} }
