(** How lights shine in the highlights of a surface.

    A highlight of sharpness [s] shows of each light what reaches the surface,
    with [(max 0 (R . L))^s] in the place of the cosine: [R] is the direction
    in which the surface mirrors the ray, [L] that towards the light (Bui Tuong
    Phong, {e Illumination for computer generated pictures}, 1975). *)

open Raylab_geometry

type t
(** The type for registers: what the lights give to each highlight of a
    surface, in the order of its highlights. *)

val create : unit -> t
(** [create ()] is a new register, for no highlight. *)

val clear : t -> Raw_parts.t -> unit
(** [clear t highlights] makes [t] black for each of [highlights]. *)

val add :
  Light.t -> Incidence.t -> Spot.t -> Raw_ray.t -> Raw_parts.t -> t -> unit
(** [add light incidence spot ray highlights t] adds to [t] what the point of
    [light] that [incidence] has met gives to each of [highlights] of a surface
    that [ray] meets at [spot]. *)

val mean : t -> int -> unit
(** [mean t count] divides all of [t] by [count]. *)

val add_all : t -> t -> unit
(** [add_all t sum] adds [t] to [sum], which is for as many highlights. *)

val add_tinted : t -> Raw_color.t -> t -> unit
(** [add_tinted t tint sum] adds [tint] times [t] to [sum] likewise. *)

val color : t -> int -> Color.t
(** [color t k] is what highlight [k], from 0, gets. *)

val colors : t -> Color.t list
(** [colors t] is that of all. *)

(** {1 Terms} *)

val red : t -> Raw_parts.t -> int -> float
(** [red t highlights k] is the red of the colour of highlight [k] times what
    it gets. *)

val green : t -> Raw_parts.t -> int -> float
(** [green t highlights k] is its green. *)

val blue : t -> Raw_parts.t -> int -> float
(** [blue t highlights k] is its blue. *)

val term : t -> Raw_parts.t -> int -> Color.t
(** [term t highlights k] is these as a colour. *)
