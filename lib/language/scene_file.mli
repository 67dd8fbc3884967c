(** Scene files: reading and writing the scene language. *)

open Raylab_source
open Raylab_scene

val parse :
  ?time:float ->
  ?access:Access.t ->
  Sources.t ->
  (Scene.t, Scene_error.t list) result
(** [parse ~time ~access sources] is the scene that the main file of [sources]
    describes at [time], by default 0, or what is wrong with it: errors of
    syntax and of files that it includes, or all errors of validation in the
    order of the text. Other files are reached by [access], by default none. It
    takes time linear in the size of the text and raises nothing, whatever the
    bytes. More of them than {!max_size} are an error, without a place. *)

val load :
  ?time:float ->
  ?access:(string -> Access.t) ->
  string ->
  (Scene.t, Scene_error.t list) result
(** [load ~time ~access path] is the scene in the file at [path], or on
    standard input if [path] is ["-"], as
    {!parse}[ ~time ~access:(access path)] reads it. A file that cannot be
    read, or is too large, is an error. *)

type reading = {
  sources : Sources.t;
      (** all files that were read for it, the main one first; none if that
          could not be read *)
  named : (Span.t * string) list;
      (** where a file is named, with the quotes, and the path of it *)
  missing : string list;  (** paths of files that could not be read *)
  meshes : Raylab_geometry.Mesh.t list;
      (** those that were read, each once and none smooth *)
  scene : (Scene.t, Scene_error.t list) result;
  noted : Warning.t list;
      (** of names that take over a word of the language, and of what files of
          meshes have and raylab does not use *)
}
(** The type for scenes and the files that they come from. *)

val findings : reading -> Warning.t list
(** [findings reading] is what is allowed but hardly meant: in the text, and,
    if it is right, in the scene; see {!Raylab_scene.Scene.findings}. *)

val provenance : reading -> Origin.t -> Provenance.t option
(** [provenance reading] is {!Raylab_scene.Provenance.make} of the files of
    [reading]. *)

val warnings : reading -> string list
(** [warnings reading] is the {!findings}, a sentence each, with their places.
*)

val read : ?time:float -> ?access:(string -> Access.t) -> string -> reading
(** [read ~time ~access path] is {!load}[ ~time ~access path] together with all
    that was read. *)

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

val expand : Format.formatter -> Scene.t -> unit
(** [expand ppf scene] writes [scene] as {!print} does, and behind each light
    and object where it comes from, as a comment. *)
