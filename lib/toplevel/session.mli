(** The session: what the words of the prompt are about.

    It is the one place of the library with state that lasts: a prompt is a
    conversation, and a conversation has a subject. *)

open Raylab_scene
open Raylab_language
open Raylab_tracer

val scene : unit -> Scene.t
(** [scene ()] is the current scene, at first {!Build.empty}. *)

val file : unit -> string option
(** [file ()] is the file that the current scene was loaded from, if it was
    from one that has a name; see {!Raylab_picture.Target.has_name}. *)

val time : unit -> float
(** [time ()] is the time at which it was read, 0 if it was not. *)

val trace : unit -> Prepared.t
(** [trace ()] is the current scene made ready for tracing. *)

val use : Scene.t -> unit
(** [use scene] makes [scene] the current one and ends the walk. *)

val allow : string list -> unit
(** [allow folders] lets scenes include files in [folders], too, from now on.
*)

val allowed : unit -> string list
(** [allowed ()] is these folders. *)

val read : ?time:float -> string -> Scene_file.reading
(** [read ~time path] is the scene in a file at [time], by default 0, with all
    that it includes. *)

val load : ?time:float -> string -> Scene_file.reading
(** [load ~time path] is {!read}[ ~time path]. If that is right it is the
    current scene, else nothing has changed. *)

val walk : unit -> Walk.t option
(** [walk ()] is where the walk through the steps of a ray is, if there is one.
*)

val set_walk : Walk.t -> unit
(** [set_walk place] is where the walk goes on. *)
