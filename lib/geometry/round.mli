(** Circles: where what is round around an axis lies. A circle is given by its
    centre and its radius, those of one shape all lie across one axis. *)

val box : (Vec3.t * float) list -> Direction.t -> Box3.t
(** [box circles axis] is a box around all [circles] across [axis]. Along x a
    circle reaches [radius * sqrt (axis.y^2 + axis.z^2)] far. *)

val place : (Vec3.t * float) list -> float array
(** [place circles] is the numbers of [circles], in an order that does not
    depend on theirs. *)

val rim : Direction.t -> Vec3.t * float -> Vec3.t list
(** [rim axis circle] is 24 points of [circle], all around [axis] in equal
    steps. Circles across one axis have theirs at the same angles. *)
