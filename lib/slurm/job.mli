(** A picture as a job for Slurm: an array of tasks that render bands, and a
    job that joins them.

    The scripts are for people to read and to edit. They work in a folder that
    holds the scene as [picture.scene] and, to begin with, the empty folders
    {!folders}; band number [k], counted from 1, becomes [bands/k.ppm] there.
*)

type t = {
  raylab : string;  (** the path of the program *)
  view : string list;
      (** options of [raylab render] that change the picture *)
  height : int;  (** of the whole picture, in rows *)
  bands : int;  (** how many, from 1 to [height] *)
  cores : int;  (** that each band is rendered on *)
  out : string;  (** the absolute path of the whole picture *)
}
(** The type for jobs. The strings may have any characters but 0. *)

val scene : string
(** [scene] is the name of the scene in the folder. *)

val folders : string list
(** [folders] is the names of the folders in the folder. *)

val submit : string
(** [submit] is the name of the script that submits the others. *)

val names : string list
(** [names] is the names of {!scripts}. *)

val scripts : t -> (string * string) list
(** [scripts job] is names and texts of the scripts, in bash:

    - [bands.sbatch], the array. A task leaves a band alone that is there, and
      tries three times if rendering fails, unless it would fail again. A task
      whose node is lost is queued again by Slurm.
    - [join.sbatch], which writes [job.out].
    - [submit], which submits those bands that are not there yet, and the join
      after them. *)
