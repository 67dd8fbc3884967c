(** Surfaces: what an object does with light. *)

type t = private
  | Diffusive of Color.t  (** returns this part of the light that reaches it *)
  | Reflective  (** a perfect mirror *)
  | Luminous of Color.t  (** shows this colour, whatever the light *)
  | Mixed of (float * t) list
      (** the weighted sum of at least one surface; weights are taken as they
          are, not brought to a sum of 1 *)

(** {1 Building}

    Raises [Invalid_argument] if a channel or a weight is negative or not
    finite, or a mix is empty. *)

val diffusive : Color.t -> t
val reflective : t
val luminous : Color.t -> t

val mixed : (float * t) list -> t
(** [mixed parts] is the mix of [parts], each a weight and a surface. A mix
    among them that is not the last is replaced by its own parts, with their
    weights multiplied by its weight: the scene language cannot write in any
    other way, and the meaning is the same as far as doubles reach. *)

(** {1 Meaning} *)

type meaning = {
  emission : Color.t;  (** the light that the surface gives off by itself *)
  albedo : Color.t;  (** the part that it returns of the light reaching it *)
  mirror : float;  (** the part that it returns of what it mirrors *)
}
(** Every surface, however mixes nest, denotes such a triple, because each kind
    is linear: its colour at a point is
    [emission + albedo * light + mirror * trace (mirrored ray)]. *)

val meaning : t -> meaning
(** [meaning surface] is the triple that [surface] denotes. Numbers too large
    for a double become the largest finite one. *)

val map_colors : (Color.t -> Color.t) -> t -> t
(** [map_colors f surface] is [surface] with [f] applied to each colour in it.

    Raises [Invalid_argument] if [f] makes a colour that no surface may have. *)

val equal : t -> t -> bool
(** [equal a b] is whether [a] and [b] are written alike, number for number. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints the surface as the scene language writes it, rounded for a
    reader: [mixed 0.5 diffusive 1 0 0 0.5 reflective]. *)
