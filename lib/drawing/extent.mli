(** How much of space the panels of a picture show. *)

open Raylab_geometry
open Raylab_scene

val of_path : Scene.t -> Path.t -> Box3.t
(** [of_path scene path] is a box around the eye, the canvas, and those hits of
    [path] and lights and spheres of [scene] that are not far away from the
    rest: three times as far from the eye as the middle one of all spheres and
    hits. Planes and spheres that are larger than that are left out. No side is
    short beside the others, and all is finite. *)
