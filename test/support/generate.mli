(** Random values of the types of geometry and scene. *)

open Raylab_geometry
open Raylab_scene
open QCheck2

(** {1 Numbers} *)

val everyday : float Gen.t
(** Numbers from -10 to 10. *)

val extreme : float Gen.t
(** Finite numbers of any size: zeros of both signs, subnormals, the largest
    and random bits, everyday ones among them. *)

val hostile : float Gen.t
(** {!extreme}, NaN and both infinities. *)

val at_least_0 : float Gen.t -> float Gen.t
(** Absolute values. *)

val positive : float Gen.t -> float Gen.t
(** Absolute values; 1 in place of 0. *)

(** {1 Geometry}

    Each from a generator of numbers. *)

val vec3 : float Gen.t -> Vec3.t Gen.t
val direction : float Gen.t -> Direction.t Gen.t
val ray : float Gen.t -> Ray.t Gen.t

val solid : float Gen.t -> Shape.t Gen.t
(** Shapes with an inside and an end. *)

val change : float Gen.t -> Change.t Gen.t
(** Up to four modifiers, with factors from 0.3 to 2.6, negative ones too. *)

val simple_shape : float Gen.t -> Shape.t Gen.t
(** As it is written, without a change. What numbers do not make, such as a
    triangle of no width, is the ball of radius 1. Meshes are those of
    {!Meshes.all}. *)

val changed_shape : float Gen.t -> Shape.t Gen.t
(** Some of them changed. *)

val solid_shape : float Gen.t -> Shape.t Gen.t
(** Only those that have an inside. *)

val solid_tree : 'member Gen.t -> 'member Solid.tree Gen.t
(** Up to three parts each, nested up to three deep. *)

val shape : float Gen.t -> Shape.t Gen.t
(** A changed shape, or a solid of such. *)

(** {1 Scenes} *)

val color : float Gen.t -> Color.t Gen.t
(** Channels are absolute values of the numbers. *)

val surface : float Gen.t -> Surface.t Gen.t
(** Mixes of up to three parts among them, nested up to three deep. *)

val light : float Gen.t -> Light.t Gen.t
val viewpoint : float Gen.t -> Viewpoint.t Gen.t
val camera : ?max_side:int -> float Gen.t -> Camera.t Gen.t

val film : Film.t Gen.t
(** Few samples, if any, and any exposure. *)

val lens : float Gen.t -> Lens.t Gen.t
(** Some of them open. *)

val object_ : float Gen.t -> Object.t Gen.t
(** Solids among them, and shadowless ones. *)

val scene : ?max_side:int -> float Gen.t -> Scene.t Gen.t
(** Pictures of up to [max_side] pixels a side, 12 by default, up to four
    lights and up to six objects. *)
