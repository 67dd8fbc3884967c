(** Scenes from OCaml values: the words of the scene language as functions.

    Each takes what its word takes in a scene file, in the same order; vectors
    are {!vec} and colours are {!rgb} or a name. A scene is then
    {!Raylab_scene.Scene.make} of a camera, lights and objects:

    {[
      Scene.make camera
        ~lights:[ spherical 20. white (vec 0. 3. 3.) ]
        ~objects:[ sphere (vec 0. 0. 6.) 1. (diffusive red) ]
    ]}

    A number that the scene language would refuse raises [Invalid_argument]. *)

open Raylab_geometry
open Raylab_scene

(** {1 Vectors, rays and colours} *)

val vec : float -> float -> float -> Vec3.t
(** [vec x y z] is the point or vector (x, y, z). *)

val ray : Vec3.t -> Vec3.t -> Ray.t
(** [ray origin direction] is the ray from [origin] along [direction], which
    may have any length but 0. *)

val rgb : float -> float -> float -> Color.t
(** [rgb r g b] is the colour with these channels, of which 1 is the brightest
    that a picture shows. *)

val black : Color.t
val white : Color.t
val red : Color.t
val green : Color.t
val blue : Color.t
val cyan : Color.t
val magenta : Color.t
val yellow : Color.t
val grey : Color.t
val orange : Color.t
val brown : Color.t
val pink : Color.t
val purple : Color.t
val gold : Color.t
val silver : Color.t

val hsv : float -> float -> float -> Color.t
(** [hsv h s v] is the colour of the hue at [h] degrees, red at 0 and green at
    120, of saturation [s] and value [v]; see {!Raylab_expression.Hsv}. *)

(** {1 Numbers}

    Whatever else the scene language computes, OCaml does, too. Angles in
    degrees are {!Raylab_expression.Degrees}. *)

val random : float -> float
(** [random k] is a fixed number from 0 to 1, exclusive, for each [k]: that of
    the scene language. *)

val noise : Vec3.t -> float
(** [noise point] is smooth noise, from -1 to 1; see
    {!Raylab_expression.Noise}. *)

val turbulence : Vec3.t -> int -> float
(** [turbulence point octaves] is the sum of ever finer noises. *)

(** {1 Lights} *)

val directional : float -> Color.t -> Vec3.t -> Light.t
(** [directional intensity color direction] is light that travels along
    [direction], as from a sun. *)

val spherical : float -> Color.t -> Vec3.t -> Light.t
(** [spherical intensity color position] is a light bulb at [position]. *)

val spot : float -> Color.t -> Vec3.t -> Vec3.t -> float -> float -> Light.t
(** [spot intensity color position target inner outer] is a light at [position]
    that shines at [target], fully up to [inner] degrees from that way, and not
    beyond [outer]. *)

val area : float -> Color.t -> Vec3.t -> Vec3.t -> Vec3.t -> int -> Light.t
(** [area intensity color corner edge other n] is the parallelogram with this
    corner and these edges, which shines from [n] x [n] points. *)

val unfading : Light.t -> Light.t
(** [unfading light] is [light], as strong far away as near. *)

(** {1 Surfaces} *)

val diffusive : Color.t -> Surface.t
(** [diffusive color] returns this part of the light that reaches it. *)

val reflective : Surface.t
(** [reflective] is a mirror. *)

val luminous : Color.t -> Surface.t
(** [luminous color] shines in this colour. *)

val glossy : float -> Color.t -> Surface.t
(** [glossy sharpness color] shows the highlights of the lights. *)

val refractive : float -> Color.t -> Surface.t
(** [refractive index color] lets this part of what is behind it through, bent.
*)

val glass : float -> Color.t -> Surface.t
(** [glass index color] mirrors, and lets this part of the rest through. *)

val mixed : (float * Surface.t) list -> Surface.t
(** [mixed parts] is the sum of [parts], each a weight and a surface. *)

val tinted : (Color.t * Surface.t) list -> Surface.t
(** [tinted parts] is {!mixed} with weights that are colours. *)

val checker : float -> Surface.t -> Surface.t -> Surface.t
(** [checker size a b] is cubes of this size, of [a] and [b] in turn. *)

val varying : string -> Surface.t
(** [varying text] is what the scene language makes of [varying] and [text], on
    a ball of radius 1 around the origin:
    [varying "p diffusive [0.5 + 0.5 * noise(p), 0.5, 0]"].

    Raises [Invalid_argument] if that is in error. *)

(** {1 Objects} *)

val sphere : Vec3.t -> float -> Surface.t -> Object.t
(** [sphere centre radius surface] is a ball. *)

val plane : Vec3.t -> Vec3.t -> Surface.t -> Object.t
(** [plane point normal surface] is the plane through [point] perpendicular to
    [normal]. *)

val box : Vec3.t -> Vec3.t -> Surface.t -> Object.t
(** [box corner opposite surface] is the box between two opposite corners. *)

val cylinder : Vec3.t -> Vec3.t -> float -> Surface.t -> Object.t
(** [cylinder a b radius surface] is the cylinder from [a] to [b]. *)

val cone : Vec3.t -> float -> Vec3.t -> float -> Surface.t -> Object.t
(** [cone a radius_a b radius_b surface] is the cone from [a] to [b] with these
    radii there. *)

val torus : Vec3.t -> Vec3.t -> float -> float -> Surface.t -> Object.t
(** [torus centre axis ring tube surface] is the ring around [axis] whose
    middle is the circle of radius [ring], and whose tube has radius [tube]. *)

val disc : Vec3.t -> Vec3.t -> float -> Surface.t -> Object.t
(** [disc centre normal radius surface] is the disc perpendicular to [normal].
*)

val triangle : Vec3.t -> Vec3.t -> Vec3.t -> Surface.t -> Object.t
(** [triangle a b c surface] is the triangle with these corners. *)

val quad : Vec3.t -> Vec3.t -> Vec3.t -> Surface.t -> Object.t
(** [quad corner edge other surface] is the parallelogram with a corner and the
    two edges that begin there. *)

val mesh : ?smooth:bool -> string -> Surface.t -> Object.t
(** [mesh ~smooth path surface] is what the file at [path] has, smooth if
    [smooth], by default not. It is in memory once if it is placed many times,
    not if it is read many times.

    Raises [Failure] if it is broken, [Sys_error] if it cannot be read. *)

(** {1 Modifiers}

    Each takes the object last: [sphere c r s |> stretched (vec 2. 1. 1.)]. *)

val scaled : float -> Object.t -> Object.t
(** [scaled k o] is [o], [k] times as large, seen from the origin. *)

val stretched : Vec3.t -> Object.t -> Object.t
(** [stretched factors o] is [o] with each coordinate multiplied by that of
    [factors], none of which is 0; a negative one mirrors. *)

val rotated : Vec3.t -> float -> Object.t -> Object.t
(** [rotated axis angle o] is [o] turned around [axis] through the origin by
    [angle] degrees, by the left-hand rule. *)

val translated : Vec3.t -> Object.t -> Object.t
(** [translated way o] is [o], moved by [way]. *)

val shadowless : Object.t -> Object.t
(** [shadowless o] is [o], which casts no shadow. *)

(** {1 Solids}

    Each raises [Invalid_argument] if there is no object, or one has no inside.
*)

val union : Object.t list -> Object.t
(** [union objects] is what is in any of [objects]. *)

val intersection : Object.t list -> Object.t
(** [intersection objects] is what is in all of [objects]. *)

val difference : Object.t list -> Object.t
(** [difference objects] is the first of [objects] without all others. *)

(** {1 Scenes} *)

val camera : Camera.t
(** [camera] takes a picture of 640 x 480 pixels through a canvas of 4 x 3 from
    a distance of 4, as the first scene of the gallery does. *)

val looking : ?up:Vec3.t -> Vec3.t -> Vec3.t -> Camera.t -> Camera.t
(** [looking ~up eye point camera] is [camera], with its canvas, moved to [eye]
    and turned towards [point], so that [up], by default (0, 1, 0), is up in
    the picture. *)

val fov : float -> Camera.t -> Camera.t
(** [fov degrees camera] is [camera] with a horizontal angle of view instead of
    its canvas. *)

val empty : Scene.t
(** [empty] is the scene that {!camera} sees when nothing is there. *)
