(** The camera: from a pixel to the ray that looks through it.

    The canvas is a rectangle centred on the origin in the plane z = 0; the eye
    is before it at (0, 0, -depth). *)

open Raylab_geometry

type t = private {
  width : int;  (** of the picture, in pixels *)
  height : int;
  canvas_width : float;  (** of the canvas, in the scene's lengths *)
  canvas_height : float;
  depth : float;  (** from the eye to the canvas *)
}
(** The type for cameras: every number is finite and greater than 0. *)

val make :
  width:int ->
  height:int ->
  canvas_width:float ->
  canvas_height:float ->
  depth:float ->
  t
(** [make ~width ~height ~canvas_width ~canvas_height ~depth] is the camera
    with these numbers.

    Raises [Invalid_argument] if one is not finite or not greater than 0, or
    [width] or [height] is greater than {!max_size}. *)

val max_size : int
(** [max_size] is 2^31 - 1: no picture format knows a larger number. *)

val with_size : width:int -> height:int -> t -> t
(** [with_size ~width ~height camera] looks at the same canvas with a picture
    of this size.

    Raises [Invalid_argument] if [width] or [height] is less than 1 or greater
    than {!max_size}. *)

val eye : t -> Vec3.t
(** [eye camera] is the point (0, 0, -depth). *)

val canvas : t -> Vec3.t * Vec3.t
(** [canvas camera] is the lower left and the upper right corner of the canvas,
    as the eye sees it. *)

val scale : t -> float
(** [scale camera] is a length that tells how large the scene's lengths are:
    the smallest of canvas width, canvas height and depth. *)

val primary_ray : t -> x:int -> y:int -> Ray.t
(** [primary_ray camera ~x ~y] is the ray from the eye through the centre of
    pixel [(x, y)]; [x] counts from the left and [y] from the top, both from 0.
    Pixels outside the picture are all right. *)

val primary_rays : t -> Ray.t Seq.t
(** [primary_rays camera] is the ray of each pixel, row by row from the top. *)

val aim : t -> x:int -> y:int -> Raw_ray.t -> unit
(** [aim camera ~x ~y ray] makes [ray] the primary ray of pixel [(x, y)]. *)

(** {1 From space to the picture}

    Places in the picture are in pixels from the left and from the top; the
    centre of pixel [(x, y)] is at [(x + 1/2, y + 1/2)]. They may be outside
    the picture. *)

val project : t -> Vec3.t -> (float * float) option
(** [project camera p] is where the eye sees [p], the inverse of
    {!primary_ray}. [None] if [p] is not before the eye. *)

val project_ray :
  t -> Ray.t -> length:float -> ((float * float) * (float * float)) option
(** [project_ray camera ray ~length] is the line that the eye sees of the first
    [length] of [ray], which may be [infinity]: from its first place to its
    last. [None] if all of it is behind the eye. *)

val equal : t -> t -> bool
(** [equal a b] is whether [a] and [b] have the same numbers. *)
