(** What is wrong with a scene, as far as it has been found. *)

open Raylab_geometry

type t
(** The type for findings in one source. *)

val start : Source.t -> t
(** [start source] is no findings, in [source]. *)

val source : t -> Source.t
(** [source findings] is what they are in. *)

val error : t -> Span.t -> ?advice:string -> string -> unit
(** [error findings span ~advice message] adds an error. *)

val check_value : t -> Number.rule -> string -> Span.t -> float -> unit
(** [check_value findings rule name span value] adds an error if [value], which
    was read from [span] and is called [name], breaks [rule]. *)

val errors : t -> Scene_error.t list
(** [errors findings] is all errors, in the order of the text. If there are
    more than 100,000 the last says only how many there are. *)
