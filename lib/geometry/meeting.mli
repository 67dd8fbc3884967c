(** Meetings: which shape a ray hits first, as far as has been found.

    A register: whoever looks for the nearest hit goes from shape to shape and
    lets each {!offer} its own; what is left at the end is the nearest of all.
*)

type t = {
  mutable number : int;  (** of the shape; {!none} if none has been hit *)
  mutable part : int;
      (** which part of the shape, such as a face, by the shape's own count
          from 0 *)
  room : Crossings.t;
      (** where a shape may work out all its crossings to know the first of
          them *)
  scratch : Scratch.t;  (** the same, for shapes that are put together *)
}
(** The type for meetings. How far away it is, is the reach of the ray. *)

val none : int
(** [none] is the number, -1, that stands for no shape. *)

val create : unit -> t
(** [create ()] is a new register, of no meeting. *)

val clear : t -> unit
(** [clear meeting] makes it a meeting with no shape. *)

val is_none : t -> bool
(** [is_none meeting] is whether it is a meeting with no shape. *)

val offer : t -> Raw_ray.t -> number:int -> part:int -> float -> unit
(** [offer meeting ray ~number ~part t] says that [ray] meets this part of
    shape [number] at distance [t]. If that is a hit, [0 < t < reach], it
    becomes the meeting and [t] the reach. Of shapes that are met at the same
    distance the one with the lowest number stays; NaN and infinity are no
    hits. *)

val offer_room : t -> Raw_ray.t -> number:int -> unit
(** [offer_room meeting ray ~number] is {!offer} of the first crossing in the
    room of [meeting] that lies in front, [t > 0]. *)
