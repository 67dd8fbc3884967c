(** Lobes: what a surface denotes.

    Every kind of surface is linear in the light around it, so whatever it is
    made of, a surface is a sum of lobes: light that it gives off, light that
    it returns to all sides, light that it mirrors or lets through. The colour
    at a point of it is

    {v
    emission + albedo * light + highlights * their shine
      + mirror * colour of the mirrored ray
      + refractions * colours of the refracted rays
    v} *)

type highlight = {
  sharpness : float;
      (** the exponent: the greater it is, the smaller is the highlight *)
  shine : Color.t;  (** the part of the lights' light that shines in it *)
}
(** The type for highlights: a mirror's blurred image of the lights. *)

type refraction = {
  index : float;
      (** how many times slower light is on the side away from the outward
          normal *)
  plain : Color.t;  (** what goes through, whatever the angle *)
  fresnel : Color.t;
      (** how much of it is glass: this times Fresnel's share is mirrored *)
  glass : Color.t;
      (** this times what Fresnel's share leaves goes through as well *)
}
(** The type for what sends a ray through the surface. *)

type t = {
  emission : Color.t;  (** the light that the surface gives off by itself *)
  albedo : Color.t;  (** the part that it returns of the light reaching it *)
  mirror : Color.t;  (** the part that it returns of what it mirrors *)
  highlights : highlight list;  (** each of another sharpness *)
  refractions : refraction list;  (** each of another index *)
}
(** The type for sums of lobes. *)

val none : t
(** [none] is the surface that does nothing. *)

val is_none : t -> bool
(** [is_none lobes] is whether all colours are black. *)

val equal : t -> t -> bool
(** [equal a b] is whether all parts are equal. *)

val pp_factor : Format.formatter -> Color.t -> unit
(** [pp_factor] prints what a colour is multiplied by: [0.5] if it is the same
    in all channels, else [rgb 0.5 0.4 0.2]. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints [emission rgb 0 0 0, albedo rgb 0.5 0 0, mirror 0.5], and then
    each highlight and refraction, such as
    [glass of index 1.5: F mirrored, (1 - F) through], where F stands for
    Fresnel's share; lines may be broken after its commas, as the box around it
    says. *)

val pp_with :
  (Format.formatter -> Color.t -> unit) -> Format.formatter -> t -> unit
(** [pp_with pp_color] is {!pp} with emission and albedo printed by [pp_color].
*)
