(** Lobes: what a surface denotes.

    Every kind of surface is linear in the light around it, so whatever it is
    made of, a surface is a sum of lobes: light that it gives off, light that
    it returns to all sides, light that it mirrors. The colour at a point of it
    is

    {v
    emission + albedo * light + mirror * colour of the mirrored ray
    v} *)

type t = {
  emission : Color.t;  (** the light that the surface gives off by itself *)
  albedo : Color.t;  (** the part that it returns of the light reaching it *)
  mirror : Color.t;  (** the part that it returns of what it mirrors *)
}
(** The type for sums of lobes. *)

val equal : t -> t -> bool
(** [equal a b] is whether all parts are equal. *)

val pp_factor : Format.formatter -> Color.t -> unit
(** [pp_factor] prints what a colour is multiplied by: [0.5] if it is the same
    in all channels, else [rgb 0.5 0.4 0.2]. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints [emission rgb 0 0 0, albedo rgb 0.5 0 0, mirror 0.5]; lines may
    be broken after its commas, as the box around it says. *)
