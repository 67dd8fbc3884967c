(** Tables in Markdown that read well in a terminal too. *)

val to_string : header:string list -> string list list -> string
(** [to_string ~header rows] is the table, its columns padded to the same
    width, the first one to the left, the others to the right. *)
