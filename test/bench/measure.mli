(** Measuring raylab: one run of one scene, in a process of its own. *)

open Raylab_tracer

type t = {
  load : Child.clock;  (** to read, parse and check the scene file *)
  build : Child.clock;  (** to make it ready, the hierarchy included *)
  render : Child.clock;  (** from there to the picture in memory *)
  tally : Tally.t;
  words : float;  (** allocated while rendering, by all domains *)
  peak : float option;
      (** bytes of memory that the process had at most; Linux alone tells *)
  picture : Digest.t;
}
(** The type for measured runs. *)

val run : domains:int -> string -> (t, string) result
(** [run ~domains path] reads the scene file at [path] and renders it over
    [domains] domains. *)

val rays : t -> float
(** [rays run] is the number of rays of all kinds. *)

val first_pixel : unit -> (float, string) result
(** [first_pixel ()] is the seconds from the start to the end of a process
    [raylab render] that renders only the first row of the first scene. *)
