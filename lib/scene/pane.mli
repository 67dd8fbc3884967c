(** The lit parallelogram of an area light, and the points at which it is
    sampled.

    It is cut into [count] times [count] equal cells, each of which has one
    point, in a place of its own that the seed of a sample decides. These
    places were chosen by measurement: see [test/bench/SAMPLES.md]. *)

open Raylab_geometry

type t = private {
  corner : Vec3.t;
  edge : Vec3.t;  (** from the corner *)
  other : Vec3.t;  (** from the corner, too *)
  count : int;  (** cells along an edge *)
}
(** The type for lit parallelograms. An edge may be the zero vector: then it is
    a line, or a point. *)

val max_count : int
(** [max_count] is 64: 4,096 points. *)

val make : corner:Vec3.t -> edge:Vec3.t -> other:Vec3.t -> count:int -> t
(** [make ~corner ~edge ~other ~count] is the parallelogram with this corner
    and these edges.

    Raises [Invalid_argument] if a corner is not finite, or [count] not from 1
    to {!max_count}. *)

val points : t -> int
(** [points pane] is the number of its cells. *)

val across : t -> int -> seed:float -> float
(** [across pane k ~seed] is how far the point of cell [k], from 0, lies along
    [edge], from 0 to 1. Cells are counted along [other] first. It is
    [(i + frac (a + j φ)) / count] for the cell at [i] along [edge] and [j]
    along [other], with [φ] the golden ratio less 1 and a number [a] from 0 to
    1 that looks random and depends on nothing but [seed], a whole number. *)

val along : t -> int -> seed:float -> float
(** [along pane k ~seed] is how far it lies along [other]: the same with [i]
    and [j] exchanged, and another number. *)

val corners : t -> Vec3.t list
(** [corners pane] is its four corners, in the order around it. *)

val transformed :
  point:(Vec3.t -> Vec3.t) -> vector:(Vec3.t -> Vec3.t) -> t -> t
(** [transformed ~point ~vector pane] is [pane] with its corner put to where
    [point] does, and its edges to where [vector] does.

    Raises [Invalid_argument] like {!make}. *)

val equal : t -> t -> bool
(** [equal a b] is whether [a] and [b] have the same numbers. *)
