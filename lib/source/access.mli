(** How other files than the main one are reached.

    The core opens no files: what hands it a scene also hands it this. *)

type found = {
  path : string;  (** by which it is opened, and people find it *)
  identity : string;  (** the same for all paths that lead to the file *)
}
(** The type for files that were found. *)

type refusal = {
  message : string;  (** why, in a line *)
  advice : string;  (** what to do, or [""] *)
}
(** The type for reasons why a file is not read. They need not be printable. *)

type t = {
  main : string option;  (** the identity of the main file, if it has one *)
  find : from:string -> string -> (found, refusal) result;
      (** [find ~from name] is the file that the one at path [from] calls
          [name], or why it must not or cannot be read *)
  read : limit:int -> found -> (string, refusal) result;
      (** [read ~limit found] is the text of the file, or why it cannot be
          read; that it has more than [limit] bytes is a reason *)
}
(** The type for ways to files. *)

val refuse : ?advice:string -> string -> ('a, refusal) result
(** [refuse ~advice message] is that refusal. *)

val none : t
(** [none] refuses every file. *)

val join : from:string -> string -> string
(** [join ~from name] is the path of the file that the one at [from] calls
    [name], which is relative to its folder; that of standard input, ["-"], is
    the current one. *)

val below : string -> string -> string option
(** [below folder path] is [path] relative to [folder] if it begins with it. *)
