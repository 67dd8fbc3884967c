(** Refraction: how a ray goes on behind a smooth surface.

    Light is [index] times slower on the side of the surface that is away from
    its outward normal than on the other. *)

type t = private {
  mutable cosine : float;
      (** of the angle between the refracted ray and the normal, greater than
          0; 0 if there is none, which is total reflection *)
  mutable share : float;
      (** Fresnel's share, from 0 to 1: the part of unpolarised light that is
          mirrored; 1 if that is all *)
  mutable dx : float;
  mutable dy : float;
  mutable dz : float;
      (** the direction of the refracted ray, if there is one *)
}
(** The type for registers of how a ray goes on. *)

val create : unit -> t
(** [create ()] is a new register. What it holds is no refraction of anything.
*)

val meet : t -> Spot.t -> Raw_ray.t -> index:float -> unit
(** [meet t spot ray ~index] puts into [t] how [ray], from the side of the
    normal of [spot], goes on there by Snell's law and Fresnel's equations. *)

val is_total : t -> bool
(** [is_total t] is whether all is mirrored. *)

val share_from_outside : index:float -> float -> float
(** [share_from_outside ~index cosine] is Fresnel's share of what comes from
    the side of the outward normal, at an angle of this cosine, from 0 to 1. *)
