(** The files of a scene: their names, and where their lines are.

    The files lie in one space of offsets, one after another, the main file
    first and from 0. Between two files is one offset: that of the end of the
    first. *)

type t
(** The type for tables of files. One is data without any text: it can be
    compared and marshalled, and is what a scene keeps of its files. *)

val none : t
(** [none] is the table of no files. *)

val add : name:string -> Lines.t -> t -> t
(** [add ~name lines files] is [files] and after them one of this name, which
    is {!Printable}, and these lines. *)

val last : t -> int
(** [last files] is the last offset, that of the end of the last file; -1 if
    there are none. *)

type found = {
  index : int;  (** which file it is; 0 is the main one *)
  name : string;
  line : Lines.line;  (** its offsets are those in the file, from 0 *)
}
(** Where an offset is. *)

val find : t -> int -> found
(** [find files offset] is where [offset] is.

    Raises [Invalid_argument] if there are no files, or it is in none of them.
*)

val place : t -> int -> Place.t option
(** [place files offset] is the place of [offset], if it is in one of [files].
*)
