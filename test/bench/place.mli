(** Files that dune builds beside the benchmark. *)

val raylab : string
(** [raylab] is the path of the program. *)

val first_scene : string
(** [first_scene] is the path of the gallery's first scene. *)

val sphereflake : string
(** [sphereflake] is the path of the gallery's [sphereflake.scene]. *)
