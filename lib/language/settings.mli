(** The words of the header. *)

open Raylab_source
open Raylab_geometry
open Raylab_scene
open Raylab_expression

type t = private {
  width : int option;
  height : int option;
  canvas_width : float option;
  canvas_height : float option;
  depth : float option;
  fov : float option;
  eye : Vec3.t option;
  look_at : Vec3.t option;
  up : Vec3.t option;
  ray_depth : int option;
  background : Background.t option;
  ambient : Color.t option;
  film : Film.t;
  aperture : float;
  focus : float option;
}
(** The type for what the settings of a header say. *)

val none : t
(** [none] is what no setting says. *)

type change = (t -> t) Written.t
(** The type for settings that are written: each changes what is known. *)

val viewpoint : t -> (Viewpoint.t, Viewpoint.problem) result option
(** [viewpoint settings] is where the eye is and where it looks; [None] if
    neither the eye nor a depth is set. *)

val camera : t -> Camera.t option
(** [camera settings] is the camera of these settings; [None] if one is missing
    or there is no {!viewpoint}.

    Raises [Invalid_argument] if the canvas leaves the range of numbers. *)

val scene :
  t -> files:Files.t -> lights:Light.t list -> objects:Object.t list -> Scene.t
(** [scene settings ~files ~lights ~objects] is the scene of these settings.

    Raises [Invalid_argument] if they make no {!camera}. *)

(** {1 Words} *)

val im_width : Expression.t -> change
val im_height : Expression.t -> change
val canv_width : Expression.t -> change
val canv_height : Expression.t -> change
val depth : Expression.t -> change
val fov : Expression.t -> change
val eye : Expression.t -> change
val look_at : Expression.t -> change
val up : Expression.t -> change
val raydepth : Expression.t -> change
val bcolor : Expression.t -> change
val ambient : Expression.t -> change

val bcolor_varying :
  string * Raylab_source.Span.t -> Raylab_expression.Expression.t -> change
(** [bcolor_varying d c] is the background [c] as a function of the direction
    [d]. *)

val samples : Expression.t -> change
val exposure : Expression.t -> change
val srgb : change
val aperture : Expression.t -> change
val focus : Expression.t -> change
