(** Tests as JavaScript. *)

val here : bool
(** [here] is whether this program is one that js_of_ocaml has made. *)
