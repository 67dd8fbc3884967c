(** Writing scenes in the scene language. *)

open Raylab_scene

val print : Format.formatter -> Scene.t -> unit
(** [print ppf scene] writes [scene], one setting, light or object a line, with
    numbers in full, so that it reads back equal. *)

val expand : Format.formatter -> Scene.t -> unit
(** [expand ppf scene] writes [scene] as {!print} does, and behind each light
    and object where it comes from, as a comment. *)
