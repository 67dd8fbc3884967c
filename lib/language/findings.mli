(** What is wrong with a scene, as far as it has been found. *)

open Raylab_source

type t
(** The type for findings in the files of one scene. *)

val start : Sources.t -> t
(** [start sources] is no findings, in [sources]. *)

val sources : t -> Sources.t
(** [sources findings] is what they are in. *)

val error : t -> Span.t -> ?advice:string -> string -> unit
(** [error findings span ~advice message] adds an error. *)

val fault : t -> Raylab_expression.Fault.t -> Raylab_expression.Trail.t -> unit
(** [fault findings fault trail] adds what an evaluation found, and the calls
    and rounds that led there, of many the innermost and the outermost. The
    same fault in a later round or call is not told again. *)

val errors : t -> Scene_error.t list
(** [errors findings] is all errors, in the order of the text. If there are
    more than 100,000 the last says only how many there are. *)
