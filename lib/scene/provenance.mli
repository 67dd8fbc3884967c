(** Where an object or a light comes from, as people are told. *)

open Raylab_source
open Raylab_expression

type what =
  | Call of { name : string; arguments : (string * Datum.t) list }
  | Round of { name : string; value : Datum.t }
  | By_name of string
      (** it was placed by this name; what made it comes before *)

type step = { what : what; place : Place.t option }
(** The type for what it went through: what it was, and where that is written.
*)

type t = {
  place : Place.t;  (** where it is written *)
  steps : step list;  (** the innermost first; none if it is written out *)
}

val make : Files.t -> Origin.t -> t option
(** [make files origin] is what [files] tell of [origin]; [None] if that is
    unknown, or they do not have it. *)

val to_string : t -> string
(** [to_string provenance] is [line 30] of what is written out, or
    [line 9, in flake(n: 2), i = 4, line 12]: where it is written, the calls
    and rounds in which it was made, the innermost first, and where the
    outermost of them is written. Of many there are the first and the last
    ones. What has been placed by its name is
    [line 2, placed as ball in line 9]. *)
