(** Where to split a node of a bounding volume hierarchy: where the
    surface-area heuristic says that a ray will have least to test, looked for
    at up to 16 places on each axis (I. Wald,
    {e On fast construction of SAH-based bounding volume hierarchies}, 2007).

    Spheres are sorted by their centres into bins along each axis; a split lies
    between two bins. *)

type space
(** The type for the room that the search works in. *)

val make_space : unit -> space
(** [make_space ()] is new room, for one domain. *)

type t =
  | Leaf  (** no split: the node is a leaf *)
  | Halves  (** into halves, whichever spheres *)
  | Bins of int * int  (** an axis, and the last bin of the first child *)

val max_depth : int
(** [max_depth] is a bound on the depth of any tree. Below a depth of 50 nodes
    are halved whatever the heuristic says, which goes on for at most 40
    levels: no array has 2^40 elements. *)

val choose :
  Bvh_leaves.t -> space -> max_leaf:int -> depth:int -> int -> int -> t
(** [choose leaves space ~max_leaf ~depth first stop] is how to split the node
    at [depth] with the spheres from [first] to [stop - 1]. A leaf has at most
    [max_leaf]. What follows is about the bins of the last choice. *)

val last_bin : space -> int
(** [last_bin space] is the last bin of each axis. *)

val partition : Bvh_leaves.t -> space -> int -> int -> int -> int -> int
(** [partition leaves space axis bin first stop] moves the spheres of the bins
    of [axis] up to [bin] to the front, and is the place where the others
    start. *)

val box_of_bins : space -> int -> int -> int -> float array
(** [box_of_bins space axis first last] is the box around the spheres in these
    bins: least and greatest x, y and z. The next box overwrites it. *)

val box_of_spheres : Bvh_leaves.t -> space -> int -> int -> float array
(** [box_of_spheres leaves space first stop] is the box around the spheres from
    [first] to [stop - 1]. The next box overwrites it. *)
