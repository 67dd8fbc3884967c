(** The shapes that have no box, such as planes: every ray is tested against
    each of them. *)

type t
(** The type for some of a scene's shapes. *)

val of_shapes : Shape.t array -> t
(** [of_shapes shapes] is those among [shapes] that have no {!Shape.box}; each
    has the number that is its place there. *)

val offer : t -> Raw_ray.t -> Meeting.t -> unit
(** [offer endless ray meeting] lets all of them offer where they meet [ray].
*)

val offer_until_one : t -> Raw_ray.t -> Meeting.t -> unit
(** [offer_until_one endless ray meeting] lets one after the other do so, until
    one is met. *)
