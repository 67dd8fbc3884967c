(** Brightness levels: the bytes of a picture. *)

val of_channel : float -> int
(** [of_channel v] is the level, from 0 to 255, of a colour channel: [v]
    clamped to \[0, 1\], times 255, rounded to the nearest integer, ties to
    even. What is encoded by a curve is so before; see {!Film}. NaN is 0. *)
