(** What is allowed in a scene but hardly meant, as it is told to people. *)

open Raylab_language

val tell : string -> Scene_file.reading -> unit
(** [tell path reading] prints the warnings of [reading], the scene at [path],
    on standard error. *)

val tell_as : Options.view -> string -> Scene_file.reading -> unit
(** [tell_as view path reading] is likewise of the picture that [view] makes of
    it, and whether the size that it asks for distorts that. *)
