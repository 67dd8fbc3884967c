(** Scenes on their way from the prompt to the native program: as they lie in
    memory, with all that is known of where their objects and lights come from.
    So both must be of one build of raylab. *)

open Raylab_scene

val write : out_channel -> Scene.t -> unit
(** [write channel scene] writes [scene], and of which build it is. It raises
    [Sys_error] if that fails. *)

val read : in_channel -> (Scene.t, string) result
(** [read channel] is the scene that {!write} has written there; or what is
    wrong: it is no such scene, not a whole one, or of another build. Whatever
    comes after the mark of this build is believed, so [channel] must be from
    the prompt itself. *)
