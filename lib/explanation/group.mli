(** Groups of a pixel's samples: those that see the same. *)

open Raylab_tracer

type t = {
  sees : string;  (** what they do; see {!Reason.sees} *)
  numbers : int list;  (** of the samples, from 1, in ascending order *)
  sample : Explain.sample;  (** the first of them *)
}
(** The type for groups. *)

val of_pixel : Explain.pixel -> t list
(** [of_pixel pixel] is the groups of its samples, the largest first; of
    equally large ones that of the earlier sample. *)

val rays : Explain.pixel -> Explain.t list
(** [rays pixel] is the ray of the first sample of each of these groups. *)

val size : t -> int
(** [size group] is how many samples are in it. *)
