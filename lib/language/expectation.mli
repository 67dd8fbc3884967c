(** What the parser expects in each state in which it can stop: from the
    productions that it is in the middle of, and the table of words. *)

type t = {
  noun : string;  (** what should stand there: ["number"] *)
  advice : string;  (** more of it, a sentence *)
}
(** The type for expectations. *)

val of_items : Parser_state.item list -> t option
(** [of_items items] is what is expected in a state of these items. *)

val of_state : int -> t
(** [of_state state] is what is expected in [state]. *)
