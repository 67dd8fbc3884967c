(** What it means for two values to be the same, for alcotest. *)

open Raylab_geometry
open Raylab_scene

val number : float Alcotest.testable
(** Equal as numbers, and NaN is NaN. *)

val near : float -> float Alcotest.testable
(** [near e] is: not further apart than [e], and neither is NaN. *)

val vec3 : Vec3.t Alcotest.testable
val vec3_near : float -> Vec3.t Alcotest.testable
val direction : Direction.t Alcotest.testable
val direction_near : float -> Direction.t Alcotest.testable

val ray_near : float -> Ray.t Alcotest.testable
(** Origin, direction and reach. *)

val color : Color.t Alcotest.testable
val color_near : float -> Color.t Alcotest.testable

val background : Background.t Alcotest.testable
(** [background] compares backgrounds by {!Background.equal}. *)

val color_about : float -> Color.t Alcotest.testable
(** [color_about e] allows an error of [e] of 1 and of each channel. *)

val surface : Surface.t Alcotest.testable
val lobes : Lobes.t Alcotest.testable

val lobes_near : float -> Lobes.t Alcotest.testable
(** [lobes_near e] allows an error of [e] relative to the larger number. *)

val light : Light.t Alcotest.testable
val object_ : Object.t Alcotest.testable
val scene : Scene.t Alcotest.testable
val levels : (int * int * int) Alcotest.testable
