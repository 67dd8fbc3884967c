(** What a representation of colours offers. *)
module type S = sig
  type t
  (** The type for colours. Channels are light intensities: 0 is none, 1 is
      what a picture shows as full brightness, and more is allowed. *)

  val black : t
  (** [black] is no light: 0 in each channel. *)

  val white : t
  (** [white] is 1 in each channel. *)

  val add : t -> t -> t
  (** [add a b] is the light of both, channel by channel. *)

  val scale : float -> t -> t
  (** [scale k c] is [c] made [k] times as bright. *)

  val multiply : t -> t -> t
  (** [multiply a b] is the product channel by channel: what a surface of
      colour [a] returns of the light [b]. *)

  val to_bytes : t -> int * int * int
  (** [to_bytes c] is the red, green and blue byte that a picture shows, by
      {!Level.of_channel}. *)

  val equal : t -> t -> bool
  (** [equal a b] is whether all channels are equal as numbers. *)

  val pp : Format.formatter -> t -> unit
  (** [pp] prints the channels for a reader; see {!Raylab_geometry.Number.pp}.
  *)
end
