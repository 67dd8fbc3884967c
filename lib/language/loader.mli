(** All files of a scene, read and parsed. *)

open Raylab_source

type t = {
  sources : Sources.t;  (** all files that were read, the main one first *)
  named : (Span.t * string) list;
      (** where a file is named, with the quotes, and the path of it *)
  missing : string list;  (** paths of files that could not be read *)
  taken : Taken.t list;
      (** in the order of the files, and of the text in each *)
  meshes : Raylab_geometry.Mesh.t list;
      (** those that were read, none smooth *)
  unused : Raylab_scene.Warning.t list;
      (** what files of meshes have and raylab does not use *)
  syntax : (Syntax.t, Scene_error.t list) result;
}
(** The type for what was read. *)

val most_nested : int
(** [most_nested] is 100: how deep files include each other. *)

val max_size : int
(** [max_size] is 2^31 - 1 bytes, almost 2 GiB: how much all files have
    together. *)

val read : Access.t -> Sources.t -> t
(** [read access sources] reads what the main file of [sources], its only one,
    includes, and the meshes that it uses. A file is read once, however often
    it is named. What is wrong is one error of syntax a file, and files that
    cannot be read, where they are named. It raises nothing, whatever the
    bytes. *)
