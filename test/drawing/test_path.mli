open Raylab_scene

val scene : Scene.t
(** [scene] is a mirror before the eye, and behind it a wall that is lit by one
    light, and not by another, which a sphere is in the way of. *)

val suite : unit Alcotest.test
(** [suite] is the tests called Path. *)
