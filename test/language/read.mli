(** Ways to read scenes from strings, for these tests. *)

open Raylab_scene
open Raylab_language

val result : string -> (Scene.t, Scene_error.t list) result
(** [result text] is what {!Scene_file.parse} makes of [text], a file called
    [test.scene]. *)

val show_errors : Scene_error.t list -> string
(** [show_errors errors] is [errors] as they are printed. *)

val scene : string -> Scene.t
(** [scene text] is the scene in [text]; the test fails if there is an error.
*)

val with_header : string -> string
(** [with_header text] is [text] after one line with a header that is right. *)

val camera : Camera.t
(** [camera] is the camera of that header. *)

val errors : string -> Scene_error.t list
(** [errors text] is the errors in [text]; the test fails if there is none. *)

val check_errors : string -> string -> unit
(** [check_errors what block] fails unless the scene in [block] has exactly the
    errors that are marked in it, in this order. A line of [block] that starts
    with [^] marks an error of the line of scene above it: the carets stand
    below what is in error, and the message follows them; [...] stands for the
    rest of a long one. The first line of [block] is left out. *)
