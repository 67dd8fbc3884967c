(** Which part of space a picture of a path shows. *)

open Raylab_geometry
open Raylab_scene
open Raylab_tracer

type t = { low : Vec3.t; high : Vec3.t }
(** The type for boxes, by two opposite corners. No side is short beside the
    others, and all is finite. *)

val fit : Scene.t -> Explain.t -> t
(** [fit scene e] is a box around the eye, the canvas, and those hits and
    lights of [e] and spheres of [scene] that are not far away from the rest:
    three times as far from the eye as the middle one of all spheres and hits.
    Planes and spheres that are larger than that are left out. *)
