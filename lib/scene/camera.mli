(** The camera: from a pixel to the ray that looks through it.

    The canvas is a rectangle before the eye, as wide and high as the frame of
    the {{!Viewpoint}viewpoint} says, whose middle the eye looks at. Unless a
    camera is placed it is centred on the origin in the plane z = 0, and the
    eye is at (0, 0, -depth). *)

open Raylab_geometry

type t = private {
  width : int;  (** of the picture, in pixels *)
  height : int;
  fov : float option;
      (** the horizontal angle of view in degrees, if the canvas is made from
          it *)
  canvas_width : float;  (** of the canvas, in the scene's lengths *)
  canvas_height : float;
  depth : float;  (** from the eye to the canvas *)
  viewpoint : Viewpoint.t;
}
(** The type for cameras: sizes, angle and depth are finite and greater than 0.
*)

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

val of_fov : width:int -> height:int -> fov:float -> Viewpoint.t -> t
(** [of_fov ~width ~height ~fov viewpoint] sees from [viewpoint] under a
    horizontal angle of [fov] degrees: its canvas stands at the point looked
    at, is so wide that it fills the angle, and has the proportions of the
    picture.

    Raises [Invalid_argument] as {!make} does, if [fov] is not between 0 and
    180, or the canvas leaves the range of doubles. *)

val max_size : int
(** [max_size] is 2^31 - 1: no picture format knows a larger number. *)

val with_size : width:int -> height:int -> t -> t
(** [with_size ~width ~height camera] takes a picture of this size through the
    same canvas; under the same angle, if [camera] has one.

    Raises [Invalid_argument] if [width] or [height] is less than 1 or greater
    than {!max_size}, and as {!of_fov} does. *)

val with_viewpoint : Viewpoint.t -> t -> t
(** [with_viewpoint viewpoint camera] is [camera], eye and canvas, moved to
    [viewpoint]; under the same angle, if [camera] has one.

    Raises [Invalid_argument] as {!of_fov} does. *)

val is_placed : t -> bool
(** [is_placed camera] is whether [camera] is moved from where {!make} puts it.
*)

val eye : t -> Vec3.t
(** [eye camera] is the point from which it sees. *)

val corners : t -> Vec3.t * Vec3.t * Vec3.t * Vec3.t
(** [corners camera] is the four corners of the canvas as the eye sees them:
    lower left, lower right, upper right, upper left. *)

val scale : t -> float
(** [scale camera] is a length that tells how large the scene's lengths are:
    the smallest of canvas width, canvas height and depth, the canvas as it is
    placed. *)

val primary_ray : t -> x:int -> y:int -> Ray.t
(** [primary_ray camera ~x ~y] is the ray from the eye through the centre of
    pixel [(x, y)]; [x] counts from the left and [y] from the top, both from 0.
    Pixels outside the picture are all right. *)

val primary_rays : t -> Ray.t Seq.t
(** [primary_rays camera] is the ray of each pixel, row by row from the top. *)

val ray_through : t -> x:int -> y:int -> dx:float -> dy:float -> Ray.t
(** [ray_through camera ~x ~y ~dx ~dy] is the ray through the place that is
    [dx] to the right of the left edge and [dy] below the upper edge of pixel
    [(x, y)], in pixels: {!primary_ray} for a half. *)

val aim : t -> x:int -> y:int -> dx:float -> dy:float -> Raw_ray.t -> unit
(** [aim camera ~x ~y ~dx ~dy ray] makes [ray] that of {!ray_through}. *)

(** {2 Centres}

    The places of the centres are the same in each row and in each column. *)

type centres
(** Where the centres of a camera's pixels are on its canvas. *)

val centres : t -> centres
(** [centres camera] is those of its picture, or of its first 65,536 columns
    and rows. *)

val no_centres : centres
(** [no_centres] knows none of them, for a single ray. *)

val aim_at_centre : t -> centres -> x:int -> y:int -> Raw_ray.t -> unit
(** [aim_at_centre camera centres ~x ~y ray] makes [ray] that of
    {!primary_ray}, bit for bit, and quicker where [centres] knows the place.
*)

val fan : t -> Fan.source
(** [fan camera] is what its primary rays have in common. *)

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

val pp_view : Format.formatter -> t -> unit
(** [pp_view] prints how the camera looks, but not the size of its picture: the
    canvas or the angle, and the viewpoint of one that is placed, on a second
    line of a vertical box. *)
