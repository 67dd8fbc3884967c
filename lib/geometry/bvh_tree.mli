(** The tree of a bounding volume hierarchy, and how it is built. *)

(* Large arrays outside the heap take memory only for the part that is used. *)

type boxes = (float, Bigarray.float64_elt, Bigarray.c_layout) Bigarray.Array1.t
type links = (int, Bigarray.int_elt, Bigarray.c_layout) Bigarray.Array1.t

type t = private {
  boxes : boxes;
      (** twelve numbers for each inner node: for each of its two children the
          least and greatest x, y and z of a box that holds it, in the order
          xmin xmax ymin ymax zmin zmax *)
  links : links;
      (** three for each inner node: the code of each child, and the axis (0, 1
          or 2) along which the first child comes before the second *)
  root : int;  (** the code of the whole tree *)
  nodes : int;  (** how many inner nodes are in use, the first ones *)
}
(** The type for trees. An inner node's code is its number; a leaf's is
    negative: {!leaf_kind}, {!leaf_first} and {!leaf_last} read it. That of no
    node is {!none}. *)

val none : int
(** [none] is the code of an empty tree. *)

val leaf_kind : int -> Bvh_leaves.kind
(** [leaf_kind code] is the kind of all shapes of the leaf. *)

val leaf_first : int -> int
(** [leaf_first code] is the place of the leaf's first shape. *)

val leaf_last : int -> int
(** [leaf_last code] is the place of the leaf's last shape. *)

val build : domains:int -> Bvh_leaves.t -> t
(** [build ~domains leaves] is the tree over these shapes, which it brings into
    the order of the leaves; split as {!Bvh_split} chooses. *)

val compact : t -> t
(** [compact tree] is [tree] in arrays that have no more than its nodes, so
    that trees which were built alike are equal. *)
