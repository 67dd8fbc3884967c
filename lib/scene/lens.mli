(** The lens of the camera: what is out of focus is blurred. *)

type t = private {
  aperture : float;  (** the radius of the lens; 0 is a pinhole *)
  focus : float option;
      (** how far from the eye, along the view, all is sharp; by default as far
          as the canvas *)
}
(** The type for lenses. *)

val pinhole : t
(** [pinhole] has the aperture 0: all is sharp. *)

val make : ?focus:float -> float -> t
(** [make ~focus aperture] is the lens of this radius.

    Raises [Invalid_argument] if [aperture] is negative, [focus] is not greater
    than 0, or one is not finite. *)

val is_open : t -> bool
(** [is_open lens] is whether its aperture is not 0. *)

val equal : t -> t -> bool
(** [equal a b] is whether [a] and [b] are the same. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints [aperture 0.1, focus 5]; without [focus] where that is the
    canvas. *)
