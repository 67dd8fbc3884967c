(** Where to read about the scene language. *)

val manual : string * int
(** [manual] is the page of the manual. *)

val blocks : Cmdliner.Manpage.block list
(** [blocks] says so, and where the page with pictures, the gallery and the
    lesson are: in the folder in which they were installed beside this program,
    if they are there. *)
