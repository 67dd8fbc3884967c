(** Lists of numbered colours in a row, for inner loops: the highlights or the
    refractions of a surface.

    A part is a key, which is a sharpness or an index, and some colours that
    are linear in the weight of a mix. It lies in the array as the key and red,
    green and blue of each colour. No two parts of a mix have the same key. *)

type t = private {
  size : int;  (** numbers of a part: 1 and 3 a colour *)
  mutable numbers : float array;
  mutable count : int;  (** of the parts, which come first in [numbers] *)
}
(** The type for lists. It grows as it must. *)

val create : colors:int -> t
(** [create ~colors] is an empty list, of parts of so many colours. *)

val clear : t -> unit
(** [clear parts] makes [parts] empty. *)

val add : t -> float -> int
(** [add parts key] adds a part of this key at the end, all black, and is the
    place of its key in [parts.numbers]. *)

val set : t -> int -> Color.t -> unit
(** [set parts at color] writes [color] at [at] of [parts.numbers]. *)

val mix : t -> first:int -> from:int -> Color.t -> unit
(** [mix parts ~first ~from weight] multiplies the parts from number [from] on
    by [weight] and adds them, in their order, to those between [first] and
    [from]: to the one of the same key, or else as another. Numbers too large
    for a double become the largest finite one. *)
