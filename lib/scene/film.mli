(** Film: how the colours that rays bring become what a picture shows. *)

type t = private {
  samples : int;  (** of a pixel at most, from 1 to {!max_samples} *)
  exposure : float;  (** the factor of every colour, greater than 0 *)
  srgb : bool;  (** whether channels are encoded by the sRGB curve *)
}
(** The type for films. *)

val default : t
(** [default] takes one sample a pixel, with exposure 1 and no encoding. *)

val make : ?samples:int -> ?exposure:float -> ?srgb:bool -> unit -> t
(** [make ~samples ~exposure ~srgb ()] is this film, by default as {!default}.

    Raises [Invalid_argument] if [samples] is not from 1 to {!max_samples}, or
    [exposure] is not finite and greater than 0. *)

val max_samples : int
(** [max_samples] is 4,096. *)

(** {1 With one thing changed} *)

val with_samples : int -> t -> t
(** [with_samples n film] takes at most [n] samples; see {!make}. *)

val with_exposure : float -> t -> t
(** [with_exposure k film] has the exposure [k]; see {!make}. *)

val with_srgb : bool -> t -> t
(** [with_srgb srgb film] encodes so. *)

(** {1 Colours} *)

val expose : t -> Color.t -> Color.t
(** [expose film c] is [c] times the exposure, each channel brought into \[0,
    1\]. *)

val over_exposed : t -> Color.t -> bool
(** [over_exposed film c] is whether [c] times the exposure is brighter in a
    channel than a picture can show: it would be shown as a level above 255 if
    there were one. *)

val channel : t -> float -> float
(** [channel film v] is [v], of an exposed colour, encoded: as it is, or by
    {!Srgb.encode}. *)

val encode : t -> Color.t -> Color.t
(** [encode film c] is [c], exposed, with each channel encoded. *)

val to_bytes : t -> Color.t -> int * int * int
(** [to_bytes film c] is the bytes that a picture shows of [c], exposed. *)

(** {1 As a whole} *)

val equal : t -> t -> bool
(** [equal a b] is whether [a] and [b] are the same. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints [samples 16, exposure 1, srgb]; the last only if it is so. *)
