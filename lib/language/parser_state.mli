(** The states of the parser, as the grammar has them. *)

type item = {
  whole : string;  (** the nonterminal symbol that is being read *)
  before : string list;  (** the symbols of it that have been read *)
  after : string list;  (** those that it still lacks *)
}
(** The type for productions that a state is in the middle of. *)

val items : item list array
(** [items] is those of each state. *)
