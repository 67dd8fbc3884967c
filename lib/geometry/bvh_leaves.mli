(** What a bounding volume hierarchy is built over: shapes or triangles, each
    known by its box. Building the tree brings them into the order of its
    leaves. *)

type t
(** The type for leaves. Each lies at a place, from 0. *)

(** Spheres are tested by their numbers in a loop of their own, all others by a
    function. So that a leaf of the tree has one kind, what is in it does. *)
type kind = Sphere | Other  (** The type for kinds. *)

val create : kinds:(int -> kind) -> int -> t
(** [create ~kinds count] is [count] of them, each of which has the number that
    is its place, and the kind that [kinds] tells of its number. Their boxes
    are still to be set, and their numbers may be others. *)

val set_side : t -> int -> int -> float -> unit
(** [set_side leaves place k x] makes [x] the {!side} [k] of a box. *)

val set_number : t -> int -> int -> unit
(** [set_number leaves place number] makes [number] the one at [place]. *)

val count : t -> int
(** [count leaves] is how many there are. *)

val side : t -> int -> int -> float
(** [side leaves place k] is a side of the box at [place]: for [k] from 0 to 5
    the least x, the greatest x, and so on for y and z. *)

val centre : t -> int -> int -> float
(** [centre leaves place axis] is a coordinate of the middle of the box at
    [place]: x for [axis] 0, y for 1 and z for 2. *)

val partition : t -> (int -> bool) -> int -> int -> int
(** [partition leaves goes_first first stop] moves those from [first] to
    [stop - 1] at whose places [goes_first] holds to the front, and is the
    place where the others start. *)

val kind : t -> int -> kind
(** [kind leaves place] is the kind of the shape at [place]. *)

val one_kind : t -> int -> int -> bool
(** [one_kind leaves first stop] is whether those from [first] to [stop - 1],
    at least one, are of one kind. *)

(** {1 In the order of the leaves} *)

val numbers : t -> int array
(** [numbers leaves] is the number of the shape at each place. *)
