(** What is wrong with a scene file, and where. *)

open Raylab_source

type t = {
  file : string;
  place : Sources.place option;  (** [None]: the file could not be read *)
  message : string;  (** what is wrong, in one line *)
  excerpt : string;
      (** the line in question with a marker under the place, or [""] *)
  advice : string;  (** what to do, or [""] *)
}
(** The type for errors. All strings are printable; see
    {!Raylab_source.Printable}. *)

val make : Sources.t -> Span.t -> ?advice:string -> string -> t
(** [make sources span message] is the error that [span] is wrong. *)

val whole : Sources.t -> Sources.file -> ?advice:string -> string -> t
(** [whole sources file message] is the error that all of [file] is wrong. Its
    place is the start, and it has no excerpt. *)

val unreadable : file:string -> string -> t
(** [unreadable ~file reason] is the error that [file] cannot be read. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints the error as a compiler does, [file:line:columns: error:] and
    the message first, then excerpt and advice. *)
