(** What a ray sees that meets nothing. *)

open Raylab_geometry
open Raylab_expression

type t = private
  | Plain of Color.t
  | Varying of {
      pattern : Surface.t Closed.t;  (** a colour, of the ray's direction *)
      grey : bool;  (** whether it counts as the grey of it *)
    }

val plain : Color.t -> t
(** [plain color] is the same in every direction.

    Raises [Invalid_argument] if a channel is negative or not finite. *)

val varying : Surface.t Closed.t -> t
(** [varying pattern] is the colour that [pattern] is at the direction of the
    ray, of length 1. *)

val at : t -> Vec3.t -> Color.t
(** [at background direction] is what it is there.

    Raises {!Pattern.Failed} if it has no value. *)

type reader
(** The type for what reads a background. Each is used by one domain. *)

val reader : t -> reader
(** [reader background] reads [background]. *)

val read : reader -> Raw_ray.t -> Raw_color.t -> unit
(** [read reader ray color] puts what it is in the direction of [ray] into
    [color].

    Raises {!Pattern.Failed} if it has no value. *)

val read_at : reader -> Vec3.t -> Color.t
(** [read_at reader direction] is what it is there.

    Raises {!Pattern.Failed} likewise. *)

val greyscale : t -> t
(** [greyscale background] is [background] with the grey of its luminance for
    each colour. *)

val colors : t -> Color.t list
(** [colors background] is its colour; of a pattern those in some directions.
*)

val equal : t -> t -> bool
(** [equal a b] is whether [a] and [b] are written alike. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints [rgb 0 0 1], and [varying d [d.y, 0, 1]]. *)
