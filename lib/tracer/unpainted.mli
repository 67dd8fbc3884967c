(** Patterns that have no value while a picture is rendered. *)

exception Found of string list
(** [Found lines] is raised in place of a colour: [lines] tell the user what is
    wrong, where it is written, at which point and in which pixel. *)

val raise_ :
  Prepared.t -> ?pixel:int * int -> Raylab_scene.Pattern.failure -> 'a
(** [raise_ prepared ~pixel failure] raises {!Found}. *)
