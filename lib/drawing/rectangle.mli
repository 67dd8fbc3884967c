(** Rectangles of a picture, in pixels from the left and from the top. *)

type t = { left : float; top : float; right : float; bottom : float }
(** The type for rectangles. *)

val around : float * float -> float -> t
(** [around p r] is the square that holds the circle around [p] of radius [r].
*)

val contains : t -> float * float -> bool
(** [contains r p] is whether [p] is in [r] or on its edge. *)

val overlap : t -> t -> bool
(** [overlap a b] is whether [a] and [b] have more in common than an edge. *)

val holds : t -> t -> bool
(** [holds a b] is whether [b] is inside [a]. *)

val way_into : t -> t -> float * float
(** [way_into a b] is the shortest way by which [b] gets into [a]; if it is too
    large, the way for its left and upper edges. *)
