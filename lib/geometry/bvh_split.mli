(** Where to split a node of a bounding volume hierarchy: where the
    surface-area heuristic says that a ray will have least to test, looked for
    at up to 16 places on each axis (I. Wald,
    {e On fast construction of SAH-based bounding volume hierarchies}, 2007).

    The middles of the boxes are sorted into bins along an axis; a split lies
    between two bins. To look along the longest axis only takes two thirds of
    the time, and gives trees in which a ray visits a tenth more. *)

type space
(** The type for the scratch space of the search. *)

val make_space : unit -> space
(** [make_space ()] is new scratch space, for one domain. *)

type t =
  | Leaf  (** no split: the node is a leaf, of one kind *)
  | Halves  (** into halves, whichever shapes *)
  | Kinds  (** spheres from other shapes *)
  | Bins of int  (** after this bin *)

val choose :
  Bvh_leaves.t -> space -> max_leaf:int -> depth:int -> int -> int -> t
(** [choose leaves space ~max_leaf ~depth first stop] is how to split the node
    at [depth] with the shapes from [first] to [stop - 1]. A leaf has at most
    [max_leaf]. *)

val partition : Bvh_leaves.t -> space -> t -> int -> int -> int
(** [partition leaves space split first stop] brings the shapes of the first
    child of this [split], which was chosen last, to the front, and is the
    place where those of the second start. *)

val axis : space -> int
(** [axis space] is the axis along which the last choice was made. *)

val box : Bvh_leaves.t -> space -> int -> int -> float array
(** [box leaves space first stop] is the box around those from [first] to
    [stop - 1]: least and greatest x, y and z. The next box overwrites it. *)
