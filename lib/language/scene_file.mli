(** Scene files: reading and writing the scene language. *)

open Raylab_scene

val parse : ?time:float -> Source.t -> (Scene.t, Scene_error.t list) result
(** [parse ~time source] is the scene that [source] describes at [time], by
    default 0, or what is wrong with it: one error of syntax, or all errors of
    validation in the order of the text. It takes time linear in the size of
    the text and raises nothing, whatever the bytes. More of them than
    {!max_size} are an error, without a place. *)

val read : string -> (Source.t, Scene_error.t list) result
(** [read path] is the text of the file at [path], or of standard input if
    [path] is ["-"]. A file that cannot be read, or is too large, is an error.
*)

val load : ?time:float -> string -> (Scene.t, Scene_error.t list) result
(** [load ~time path] is {!parse}[ ~time] of {!read}[ path]. *)

val without_extension : string -> string
(** [without_extension path] is [path] without [.scene] or [.txt] at its end,
    in any case: what else may follow a point, as in [run_0.05], is part of the
    name. *)

val max_size : int
(** [max_size] is 2^31 - 1 bytes, almost 2 GiB. *)

val print : Format.formatter -> Scene.t -> unit
(** [print ppf scene] writes [scene] in the scene language, one setting, light
    or object a line, with numbers in full: {!parse} of it is equal to [scene]
    ({!Raylab_scene.Scene.equal}). *)
