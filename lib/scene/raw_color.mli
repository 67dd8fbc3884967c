(** Colours whose channels can be overwritten: registers for inner loops, where
    storing a double allocates nothing. *)

type t = { mutable r : float; mutable g : float; mutable b : float }
(** The type for registers. *)

val create : unit -> t
(** [create ()] is a new register, black. *)

val set : t -> float -> float -> float -> unit
(** [set color r g b] puts a colour into [color], each channel limited as
    {!Saturate.limit} does. *)

val mean : t -> int -> unit
(** [mean sum count] divides each channel of [sum] by [count]. *)

val to_color : t -> Color.t
(** [to_color color] is what [color] holds. *)
