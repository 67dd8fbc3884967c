(** The sRGB curve (IEC 61966-2-1): what a screen shows of a channel. *)

val encode : float -> float
(** [encode v] is the value, from 0 to 1, that a screen shows as the brightness
    [v], also from 0 to 1: [12.92 v] up to 0.0031308, and
    [1.055 v^(1/2.4) - 0.055] beyond. *)
