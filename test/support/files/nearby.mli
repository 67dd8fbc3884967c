(** The files that scenes of the gallery include, read without Unix. *)

open Raylab_source

val access : string -> Access.t
(** [access path] reaches every file that the one at [path] names. *)
