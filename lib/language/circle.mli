(** Files that include each other. *)

open Raylab_source

type chain = (string * Span.t) list
(** The type for the files that are being read, the innermost first: the
    identity of each, and where it is included. *)

val find : string -> chain -> Span.t list option
(** [find identity chain] is the links of the circle that goes back to the file
    of this [identity], the last one first, if it is in [chain]. *)

val told : Sources.t -> Span.t list -> string
(** [told sources links] says which file includes which, a line for each. *)
