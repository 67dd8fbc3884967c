open Bigarray
open Raylab_parallel

type boxes = (float, float64_elt, c_layout) Array1.t
type links = (int, int_elt, c_layout) Array1.t
type t = { boxes : boxes; links : links; root : int; nodes : int }

(* {1 Codes} *)

let none = min_int
let max_leaf = 16

let leaf kind first count =
  let kind = match (kind : Bvh_leaves.kind) with Sphere -> 0 | Other -> 1 in
  lnot ((((first * max_leaf) + count - 1) * 2) + kind)

let[@inline] leaf_kind code : Bvh_leaves.kind =
  if lnot code land 1 = 0 then Sphere else Other

let[@inline] leaf_first code = lnot code / (2 * max_leaf)

let[@inline] leaf_last code =
  leaf_first code + (lnot code / 2 land (max_leaf - 1))

(* {1 Boxes} *)

(* A ray that touches a shape may, by rounding errors, pass its box by a
   hair. *)
let margin least greatest =
  0x1p-30 *. Float.max (abs_float least) (abs_float greatest)

let write_box tree node child (box : float array) =
  for axis = 0 to 2 do
    let least = box.(2 * axis) and greatest = box.((2 * axis) + 1) in
    let margin = margin least greatest
    and slot = (12 * node) + (6 * child) + (2 * axis) in
    tree.boxes.{slot} <- least -. margin;
    tree.boxes.{slot + 1} <- greatest +. margin
  done

(* {1 Building} *)

(* [divide tree leaves space node split first stop] puts the shapes of the
   children of [node] apart, writes their boxes, and is the place where the
   second child's begin. *)
let divide tree leaves space node split first stop =
  let middle = Bvh_split.partition leaves space split first stop in
  write_box tree node 0 (Bvh_split.box leaves space first middle);
  write_box tree node 1 (Bvh_split.box leaves space middle stop);
  tree.links.{(3 * node) + 2} <- Bvh_split.axis space;
  middle

(* A part of the tree that is still to be built: whose child it is, which
   shapes it has, and how deep it lies. *)
type part = { parent : int; first : int; stop : int; depth : int }

(* [grow tree leaves next_node space parts part] builds [part]; parts of at most
   [small] shapes it leaves to [later]. *)
let rec grow tree leaves next_node space ~small later part =
  let { parent; first; stop; depth } = part in
  if stop - first <= small then later part
  else
    let link code = tree.links.{parent} <- code in
    match Bvh_split.choose leaves space ~max_leaf ~depth first stop with
    | Leaf -> link (leaf (Bvh_leaves.kind leaves first) first (stop - first))
    | split ->
        let node = Atomic.fetch_and_add next_node 1 in
        link node;
        let middle = divide tree leaves space node split first stop in
        let child k first stop =
          grow tree leaves next_node space ~small later
            { parent = (3 * node) + k; first; stop; depth = depth + 1 }
        in
        child 0 first middle;
        child 1 middle stop

(* Fewer shapes are not worth another domain's start. *)
let worth_a_domain = 10_000

let grow_all ~domains tree leaves next_node all =
  let count = all.stop - all.first in
  let grow_rest space part =
    grow tree leaves next_node space ~small:0 ignore part
  in
  if domains = 1 || count < 2 * worth_a_domain then
    grow_rest (Bvh_split.make_space ()) all
  else
    (* the top by one domain, then the parts by all *)
    let parts = ref [] in
    let small = Int.max worth_a_domain (count / (8 * domains)) in
    let later part = parts := part :: !parts in
    grow tree leaves next_node (Bvh_split.make_space ()) ~small later all;
    let parts = Array.of_list !parts in
    ignore
      (Parallel.iter ~domains ~worker:Bvh_split.make_space
         ~count:(Array.length parts) (fun space k -> grow_rest space parts.(k)))

let build ~domains leaves =
  let count = Bvh_leaves.count leaves in
  let inner = Int.max 0 (count - 1) in
  let root_link = 3 * inner in
  let tree =
    {
      boxes = Array1.create Float64 C_layout (12 * inner);
      links = Array1.create Int C_layout (root_link + 1);
      root = none;
      nodes = 0;
    }
  in
  let next_node = Atomic.make 0 in
  tree.links.{root_link} <- none;
  if count > 0 then
    grow_all ~domains tree leaves next_node
      { parent = root_link; first = 0; stop = count; depth = 0 };
  { tree with root = tree.links.{root_link}; nodes = Atomic.get next_node }

let compact { boxes; links; root; nodes } =
  let part kind array length =
    let part = Array1.create kind C_layout length in
    Array1.blit (Array1.sub array 0 length) part;
    part
  in
  {
    boxes = part Float64 boxes (12 * nodes);
    links = part Int links (3 * nodes);
    root;
    nodes;
  }
