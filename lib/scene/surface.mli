(** Surfaces: what an object does with light.

    [doc/adding-a-surface.md] says how to add one. *)

type t = private
  | Diffusive of Color.t  (** returns this part of the light that reaches it *)
  | Reflective  (** a perfect mirror *)
  | Luminous of Color.t  (** shows this colour, whatever the light *)
  | Glossy of { sharpness : float; color : Color.t }
      (** shines where it mirrors a light, blurred *)
  | Refractive of { index : float; color : Color.t }
      (** lets this part through, bent *)
  | Glass of { index : float; color : Color.t }
      (** mirrors Fresnel's share, and lets this part of the rest through *)
  | Mixed of {
      parts : (Color.t * t) list;
          (** at least one, each with its weight, a grey for a number; weights
              are taken as they are, not brought to a sum of 1 *)
      nesting : int;
          (** how deep mixes and checkers are nested: 1 without another among
              [parts] *)
    }  (** the weighted sum of surfaces *)
  | Checker of {
      size : float;  (** greater than 0 *)
      even : t;
      odd : t;
      nesting : int;  (** likewise *)
      count : int;  (** {!val-count} *)
    }  (** cubes of two surfaces in turn *)
  | Varying of {
      pattern : t Raylab_expression.Closed.t;
      grey : bool;  (** whether each colour counts as the grey of it *)
      nesting : int;  (** likewise; what is in it is among its values *)
    }  (** a function of the point *)

(** {1 Building}

    Raises [Invalid_argument] if a channel, a weight or a sharpness is negative
    or not finite, an index or a size not finite or not greater than 0, a mix
    empty, or mixes and checkers are nested too deep. *)

val diffusive : Color.t -> t
(** [diffusive color] is matt: it returns the part [color] of the light that
    reaches it, to all sides alike. *)

val reflective : t
(** [reflective] is a perfect mirror. *)

val luminous : Color.t -> t
(** [luminous color] glows in [color], whatever the light. It lights nothing
    else. *)

val glossy : sharpness:float -> Color.t -> t
(** [glossy ~sharpness color] shows the highlights of the lights: this part of
    their light, times the cosine to the power of [sharpness] of the angle
    between the way to the light and that of the mirrored ray. *)

val refractive : index:float -> Color.t -> t
(** [refractive ~index color] lets the part [color] of what is behind it
    through, along the ray that is bent by Snell's law: light is [index] times
    slower on the side away from the outward normal. What is totally reflected
    is mirrored. *)

val glass : index:float -> Color.t -> t
(** [glass ~index color] is {!refractive}, and a mirror: of the share that
    Fresnel's equations say, the rest times [color] goes through. *)

val mixed : (float * t) list -> t
(** [mixed parts] is the mix of [parts], each a weight and a surface. A mix
    among them that is not the last is replaced by its own parts, with their
    weights multiplied by its weight: the scene language cannot write in any
    other way, and the meaning is the same as far as doubles reach. The last
    one may be a mix again, and so on, {!max_nesting} deep. *)

val checker : float -> t -> t -> t
(** [checker size even odd] is cubes of this size, from the origin on along the
    axes of the shape's own coordinates: [even] where the sum of
    [floor (x / size)], [floor (y / size)] and [floor (z / size)] is even, and
    [odd] elsewhere. A point within [2^-30] of a size below the next cube
    belongs to that, so that a face between two cubes does not speckle. *)

val varying : t Raylab_expression.Closed.t -> t
(** [varying pattern] is the surface that [pattern] is at each point. *)

val max_nesting : int
(** [max_nesting] is 1,000: mixes and checkers are not nested deeper, so that
    what follows them down may recurse. *)

val count : t -> int
(** [count surface] is the number of surfaces in it, itself included, at most a
    billion: what has a name may be in it many times. *)

val tinted : (Color.t * t) list -> t
(** [tinted parts] is the same with weights that are colours: [gold] times a
    mirror is a mirror tinted gold. *)

(** {1 Meaning} *)

val lobes : ?at:Raylab_geometry.Vec3.t -> t -> Lobes.t
(** [lobes ~at surface] is what [surface] denotes at its own point [at], by
    default the origin; that makes a difference only if it {!varies}. Numbers
    too large for a double become the largest finite one. *)

val patterns : t -> t Raylab_expression.Closed.t list
(** [patterns surface] is all patterns in [surface], also those in the values
    of others, in their order. *)

type ready
(** The type for the patterns of a surface, made ready. Domains may share them.
*)

val ready : t -> ready
(** [ready surface] is all patterns in [surface]. *)

type machines
(** The type for what evaluates them. Each is used by one domain. *)

val no_machines : machines
(** [no_machines] is for surfaces that do not vary, and checkers of them. *)

val start : ready -> machines
(** [start ready] evaluates [ready]. *)

val write : machines -> t -> Raylab_geometry.Spot.t -> Raw_lobes.t -> unit
(** [write machines surface spot raw] puts what [surface] denotes at [spot]
    into [raw]; [machines] is those of the surface. Where there is no pattern
    nothing is allocated once [raw] has the room.

    Raises {!Pattern.Failed} where a pattern has no value. *)

val make : color:(Color.t -> Color.t) -> t Pattern.make
(** [make ~color] is what words make in patterns, [color] of each colour. *)

val is_plain : t -> bool
(** [is_plain surface] is whether, wherever it is, it has neither highlights
    nor refractions. *)

val paint : t -> Color.t option
(** [paint surface] is the colour that [surface] is said to be painted with:
    that of a diffusive one. A mix has none of its own. *)

val varies : t -> bool
(** [varies surface] is whether [surface] is not the same at all points. *)

val resolve : machines -> t -> Raylab_geometry.Vec3.t -> t
(** [resolve machines surface point] is {!at}[ surface point] by [machines],
    which are those of the surface. *)

val has_patterns : t -> bool
(** [has_patterns surface] is whether some part of it is {!Varying}. *)

val at : t -> Raylab_geometry.Vec3.t -> t
(** [at surface point] is what [surface] is at its own point [point]: a surface
    that does not vary. It denotes [lobes ~at:point surface], up to rounding.
*)

(** {1 Forms} *)

val greyscale : t -> t
(** [greyscale surface] is [surface] with each colour replaced by the grey of
    its luminance; also those that its patterns make. *)

val map_colors : (Color.t -> Color.t) -> t -> t
(** [map_colors f surface] is [surface] with [f] applied to each colour in it,
    those that are weights included; a weight that is the same in all channels
    is a number, and stays.

    Raises [Invalid_argument] if [f] makes a colour that no surface may have.
*)

val name : t -> string
(** [name surface] is the scene language's word for it, such as ["diffusive"].
*)

val parameters : t -> (string * Raylab_geometry.Parameter.t) list
(** [parameters surface] is what the scene language writes after {!name}, in
    that order, each with its name, all triples colours, but for the surfaces
    of which mixes and checkers are made. *)

val simple : t -> t list
(** [simple surface] is the surfaces in [surface] that are not made of others,
    in their order; of a pattern those that it is at some points. *)

val weight : Color.t -> Raylab_geometry.Parameter.t
(** [weight w] is how [w] is written as the weight of a part: one number if it
    is the same in all channels. *)

val colors : t -> Color.t list
(** [colors surface] is all colours that are written in [surface], weights that
    are colours included, in their order. *)

val equal : t -> t -> bool
(** [equal a b] is whether [a] and [b] are written alike, number for number. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints the surface as the scene language writes it, rounded for a
    reader: [mixed 0.5 diffusive 1 0 0 0.5 reflective]. *)

val pp_with :
  ?name_of:(t -> string option) ->
  (Format.formatter -> float -> unit) ->
  Format.formatter ->
  t ->
  unit
(** [pp_with ~name_of pp_number] is {!pp} with each number printed by
    [pp_number], and those of the {!parts_to_name} by their names to which
    [name_of] gives one. *)

val pp_form_with :
  ?name_of:(t -> string option) ->
  (Format.formatter -> float -> unit) ->
  Format.formatter ->
  t ->
  unit
(** [pp_form_with ~name_of pp_number] is the same, but that [surface] itself is
    written out, for the definition of its name. *)

val parts_to_name : t -> t list
(** [parts_to_name surface] is the parts that the scene language can write
    within [surface] only by a name, those first that are in others: patterns
    with values of other names, and parts of a mix that end in a mix themselves
    and are not the last. {!pp} puts the latter in brackets. *)
