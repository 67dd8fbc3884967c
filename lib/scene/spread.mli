(** Where the samples of a pixel lie: a fixed, well spread sequence.

    Coordinates lie between 0 and 1. They are the first four dimensions of I.
    M. Sobol's sequence (1967, with the direction numbers of S. Joe and F. Y.
    Kuo, 2008), of which the first two are a (0, 2)-sequence: of the first
    [2^n] samples each has a part of its own, in whichever way the pixel is cut
    into [2^n] equal boxes. Its digits are scrambled differently in each pixel
    (T. Kollig and A. Keller, 2002), or all pixels would be wrong in the same
    way; but so that sample 0 stays at the centre. It was chosen by
    measurement: see [test/bench/SAMPLES.md].

    Everything is a function of pixel and sample number alone, the same on
    every machine, and where an [int] has 32 bits. *)

type t = private int
(** The type for pixels, as far as their samples lie differently. *)

val of_pixel : x:int -> y:int -> t
(** [of_pixel ~x ~y] is pixel [(x, y)]. *)

val across : t -> int -> float
(** [across pixel k] is where in [pixel] sample [k] lies, from the left;
    exactly 0.5 for sample 0. [k] is less than {!Film.max_samples}. *)

val down : t -> int -> float
(** [down pixel k] is the same from the top. *)

val lens : t -> int -> float
(** [lens pixel k] is the first coordinate of the point of a lens for sample
    [k]. *)

val lens' : t -> int -> float
(** [lens' pixel k] is the second one. *)

val seed : t -> int -> float
(** [seed pixel k] is the seed of the rays of sample [k]: a whole number from 1
    to 2^30 that looks unlike those of other pixels and samples. *)
