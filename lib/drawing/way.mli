(** Directions in a drawing. *)

type t = float * float
(** The type for directions: of length 1, to the right and downwards. *)

val between : Drawing.point -> Drawing.point -> float * t
(** [between a b] is the distance from [a] to [b] and the direction in which
    [b] is, which is NaN if they are one. *)

val from : Drawing.point -> t -> float -> float -> Drawing.point
(** [from p way along aside] is the place [along] pixels from [p] in the
    direction [way], and then [aside] pixels to its right. *)
