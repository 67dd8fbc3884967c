(** Ratios of the measured times of one scene: of minima, NaN where one of the
    two was not measured. *)

val minimum : ('run -> float) -> 'run list -> float
(** [minimum figure runs] is the least [figure] of [runs]. *)

val median : ('run -> float) -> 'run list -> float
(** [median figure runs] is the middle [figure] of [runs]. *)

val render_one : Trial.t -> float
(** [render_one trial] is the processor time of raylab's rendering over that of
    POV-Ray's, one thread each. *)

val render_many : Trial.t -> float
(** [render_many trial] is the wall time of raylab's rendering over that of
    POV-Ray's, several threads each. *)

val build : Trial.t -> float
(** [build trial] is the wall time of raylab's hierarchy over that of
    POV-Ray's. It is NaN too if POV-Ray's is too short to be told. *)

val speed_up : Trial.t -> float
(** [speed_up trial] is the wall time of rendering over one domain over that
    over several. *)

val words_per_ray : Trial.t -> float
(** [words_per_ray trial] is the words allocated per ray, whole render, for one
    domain or several, whichever is more. *)

val load : Trial.t -> float
(** [load trial] is the time to read, parse and check the scene over the time
    to render it over one domain. *)

val bytes_per_sphere : Trial.t -> float
(** [bytes_per_sphere trial] is the peak memory of a process that reads and
    renders the scene over one domain, per sphere. *)
