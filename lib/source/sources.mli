(** The texts of all files of a scene, as long as they are needed.

    Their names and the places in them are in a table, {!Files.t}, which stays
    when the texts are dropped. *)

type t
(** The type for texts of files. *)

type attached = private {
  path : string;  (** by which it was opened *)
  bytes : string;  (** all of it *)
}
(** A file that the scene uses and that is no text of the language, such as a
    mesh. It has no place in the space of offsets. *)

type file = private {
  path : string;  (** by which it was opened *)
  base : int;  (** where it starts in the space of offsets *)
  text : string;  (** all its bytes *)
}
(** A text. *)

val none : t
(** [none] is no files. *)

val add : ?path:string -> name:string -> string -> t -> t
(** [add ~path ~name text sources] is [sources] and the file [text], without
    the byte-order mark that it may start with. [name] is what people call it,
    [path] by default the same. The first file is the main one. *)

val make : ?path:string -> name:string -> string -> t
(** [make ~path ~name text] is {!add} to {!none}. *)

val attach : path:string -> string -> t -> t
(** [attach ~path bytes sources] is [sources] and such a file. *)

val files : t -> file list
(** [files sources] is all texts, in their order. *)

val attached : t -> attached list
(** [attached sources] is what was attached to them, in its order. *)

val paths : t -> string list
(** [paths sources] is the paths of both: what is watched. *)

val table : t -> Files.t
(** [table sources] is their names and lines. *)

val size : t -> int
(** [size sources] is how many bytes all files have together. *)

val digest : t -> string
(** [digest sources] is the MD5 of the text of a single file, and of several,
    attached ones last, that of their digests, one after another. *)

(** {1 Pieces of them}

    A span or an offset that is in none of the files raises [Invalid_argument].
*)

val name : t -> int -> string
(** [name sources offset] is the name of the file in which [offset] is,
    {!Printable}. *)

val title : t -> int -> string
(** [title sources offset] is what errors call that file: its path, or, of
    standard input, its name; {!Printable}. *)

val file : t -> int -> file
(** [file sources offset] is the file in which [offset] is. *)

type place = {
  line : int;  (** counted from 1 *)
  first : int;  (** the column of the first byte, counted from 1 *)
  last : int;  (** the column of the last byte; at least [first] *)
}
(** Where a span is in its file. Columns count bytes. *)

val place : t -> Span.t -> place
(** [place sources span] is where [span] is. An empty span, or one that goes on
    in another line, gets at least one column of its first line. *)

val slice : t -> Span.t -> string
(** [slice sources span] is the text of [span], byte for byte. *)

val quote : t -> Span.t -> string
(** [quote sources span] is the text of [span], {!Printable} and shortened
    where it is long. *)

val excerpt : t -> Span.t -> string * int * int
(** [excerpt sources span] is [(line, before, length)]: the {!Printable} text
    of the line on which [span] starts, or the part around [span] of a long
    line, and the place of [span] in it, in characters. *)
