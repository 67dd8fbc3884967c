(** All runs of one scene. *)

type t = {
  scene : Scenes.t;
  file_size : int;  (** of the scene file, in bytes *)
  one : Measure.t list;  (** raylab over one domain *)
  many : Measure.t list;  (** raylab over several, none if not asked for *)
  povray_one : Povray.t list;  (** none if it is not installed *)
  povray_many : Povray.t list;
}
(** The type for what was measured. Each list has the runs in their order. *)

type plan = {
  runs : int;  (** of each kind *)
  domains : int;  (** if 1, [many] and [povray_many] stay empty *)
  povray : bool;
}
(** The type for what to measure. *)

val perform :
  plan -> dir:string -> say:(string -> unit) -> Scenes.t -> (t, string) result
(** [perform plan ~dir ~say scene] makes the files of [scene] in [dir], runs
    everything in turn, again and again, and removes the files. [say] is told
    what comes next. It is an error if a run fails, or if the pictures are not
    all the same. *)

val write_files :
  dir:string -> povray:bool -> Scenes.t -> (string * string, string) result
(** [write_files ~dir ~povray scene] writes [scene] to [dir] as a scene file
    and, if [povray], as a POV-Ray file, and is the paths of both. *)
