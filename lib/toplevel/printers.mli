(** How a prompt shows the values of the library: as mathematics does.

    Every value here is a printer for utop. Where standard output is a terminal
    that has colours, a patch of the colour follows it. *)

open Raylab_geometry
open Raylab_scene
open Raylab_language
open Raylab_tracer

(** {1 Geometry} *)

val vec3 : Format.formatter -> Vec3.t -> unit
[@@ocaml.toplevel_printer]
(** [(1, 2.5, -3)] *)

val direction : Format.formatter -> Direction.t -> unit
[@@ocaml.toplevel_printer]
(** [(0, 0, 1)] *)

val ray : Format.formatter -> Ray.t -> unit
[@@ocaml.toplevel_printer]
(** [(0, 0, -4) + t (0, 0, 1)] *)

val box : Format.formatter -> Box3.t -> unit
[@@ocaml.toplevel_printer]
(** [(-1, -1, 5) to (1, 1, 7)] *)

val shape : Format.formatter -> Shape.t -> unit
[@@ocaml.toplevel_printer]
(** [sphere centre (0, 0, 6) radius 1] *)

val sphere : Format.formatter -> Sphere.t -> unit
[@@ocaml.toplevel_printer]
(** as {!shape} *)

val plane : Format.formatter -> Plane.t -> unit
[@@ocaml.toplevel_printer]
(** as {!shape} *)

val box_shape : Format.formatter -> Box.t -> unit
[@@ocaml.toplevel_printer]
(** as {!shape} *)

val cylinder : Format.formatter -> Cylinder.t -> unit
[@@ocaml.toplevel_printer]
(** as {!shape} *)

val cone : Format.formatter -> Cone.t -> unit
[@@ocaml.toplevel_printer]
(** as {!shape} *)

val torus : Format.formatter -> Torus.t -> unit
[@@ocaml.toplevel_printer]
(** as {!shape} *)

val disc : Format.formatter -> Disc.t -> unit
[@@ocaml.toplevel_printer]
(** as {!shape} *)

val triangle : Format.formatter -> Triangle.t -> unit
[@@ocaml.toplevel_printer]
(** as {!shape} *)

val quad : Format.formatter -> Quad.t -> unit
[@@ocaml.toplevel_printer]
(** as {!shape} *)

(** {1 Scenes} *)

val color : Format.formatter -> Color.t -> unit
[@@ocaml.toplevel_printer]
(** [rgb 1 0.5 0] *)

val surface : Format.formatter -> Surface.t -> unit
[@@ocaml.toplevel_printer]
(** [mixed 0.5 diffusive 1 0 0 0.5 reflective] *)

val lobes : Format.formatter -> Lobes.t -> unit
[@@ocaml.toplevel_printer]
(** [emission rgb 0 0 0, albedo rgb 0.5 0 0, mirror 0.5] *)

val light : Format.formatter -> Light.t -> unit
[@@ocaml.toplevel_printer]
(** [spherical light, intensity 1, rgb 1 1 1, position (0, 5, 0)] *)

val object_ : Format.formatter -> Object.t -> unit
[@@ocaml.toplevel_printer]
(** [sphere centre (0, 0, 6) radius 1, reflective] *)

val camera : Format.formatter -> Camera.t -> unit
[@@ocaml.toplevel_printer]
(** [640 x 480 pixels through a canvas of 4 x 3 from (0, 0, -4)] *)

val viewpoint : Format.formatter -> Viewpoint.t -> unit
[@@ocaml.toplevel_printer]
(** [eye (3, 2, -4), lookAt (0, 0, 0)] *)

val scene : Format.formatter -> Scene.t -> unit
[@@ocaml.toplevel_printer]
(** size, lights and objects, numbered, one a line *)

val scene_error : Format.formatter -> Scene_error.t -> unit
[@@ocaml.toplevel_printer]
(** as the command line prints it *)

(** {1 Tracing} *)

val hit : Format.formatter -> Hit.t -> unit
[@@ocaml.toplevel_printer]
(** [object 3, t = 5 at (0, 0, 1), normal (0, 0, -1)] *)

val event : Format.formatter -> Event.t -> unit
[@@ocaml.toplevel_printer]
(** [nearest hit: object 3, t = 5 at (0, 0, 1), normal (0, 0, -1)] *)

val events : Format.formatter -> Event.t Seq.t -> unit
[@@ocaml.toplevel_printer]
(** [12 steps] *)

val trace : Format.formatter -> Prepared.t -> unit
[@@ocaml.toplevel_printer]
(** as {!scene} *)

val explain : Format.formatter -> Explain.t -> unit
[@@ocaml.toplevel_printer]
(** {!Raylab_explanation.Report.pp}: a summary, and the tree *)

val pixel : Format.formatter -> Explain.pixel -> unit
[@@ocaml.toplevel_printer]
(** the same of a pixel *)

val term : Format.formatter -> Explain.term -> unit
[@@ocaml.toplevel_printer]
(** [diffused rgb 0.2 0.1 0] *)

val outcome : Format.formatter -> Explain.outcome -> unit
[@@ocaml.toplevel_printer]
(** [missed], or the {!surface_hit} *)

val surface_hit : Format.formatter -> Explain.surface_hit -> unit
[@@ocaml.toplevel_printer]
(** the object and its parts of the colour *)

val explain_light : Format.formatter -> Explain.light -> unit
[@@ocaml.toplevel_printer]
(** [light 2: blocked by object 3, t = 2 at (0, 1, 0)] *)

val verdict : Format.formatter -> Explain.verdict -> unit
[@@ocaml.toplevel_printer]
(** [faces away, cosine -0.5] *)

(** {1 Pictures} *)

val picture : Format.formatter -> Picture.t -> unit
[@@ocaml.toplevel_printer]
(** [picture of 640 x 480 pixels] *)

val tally : Format.formatter -> Tally.t -> unit
[@@ocaml.toplevel_printer]
(** [10 primary, 2 reflected and 8 shadow rays, 7 hits, 3 lights blocked] *)
