(** What it means that every number is finite. *)

open Raylab_scene
open Raylab_tracer

val color : Color.t -> bool
(** [color c] is whether each channel is finite and not negative. *)

val explanation : Explain.pixel -> bool
(** [explanation e] is whether every number in [e] and all explanations in it
    is finite, the reach of a ray without end excepted. *)
