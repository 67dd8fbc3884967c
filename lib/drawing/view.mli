(** Views of space from above and from the side, as flat panels of pixels. *)

open Raylab_geometry

type side = Above  (** x to the right, z up *) | Beside  (** z right, y up *)

type t = {
  side : side;
  left : float;
  top : float;
  width : float;
  height : float;
  scale : float;  (** pixels to a length of 1 *)
  frame : Frame.t;
}
(** The type for views: a panel of the picture that shows [frame]. *)

type point = float * float
(** The type for places in the picture: from the left and from the top. *)

val across : side -> Vec3.t -> float
(** [across side v] is the component of [v] to the right. *)

val up : side -> Vec3.t -> float
(** [up side v] is the component of [v] upwards. *)

val towards_viewer : side -> Vec3.t -> float
(** [towards_viewer side v] is the component of [v] that a view does not show.
*)

val point : t -> Vec3.t -> point
(** [point view p] is where [view] shows [p], in its panel or not. *)

val contains : t -> point -> bool
(** [contains view p] is whether [p] is in the panel of [view]. *)

val rectangle : t -> Rectangle.t
(** [rectangle view] is the panel of [view]. *)

val segment : t -> Vec3.t -> Vec3.t -> float -> (point * point) option
(** [segment view origin direction length] is the part that the panel shows of
    the line from [origin] along [direction] for [length], which may be
    [infinity]. [None] if that is nothing, or a single point. *)

val line : t -> Vec3.t -> Vec3.t -> (point * point) option
(** [line view p direction] is {!segment} for the line without ends. *)
