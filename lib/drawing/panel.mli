(** Panels: parts of a sheet that show space from above or from the side. *)

open Raylab_geometry

type side = Above  (** x to the right, z up *) | Beside  (** z right, y up *)

type t = {
  side : side;
  left : float;
  top : float;
  width : float;
  height : float;
  scale : float;  (** pixels to a length of 1 *)
  space : Box3.t;  (** what is shown: its low corner is at the lower left *)
}
(** The type for panels. *)

val box : t -> Rectangle.t
(** [box panel] is the part of the sheet where [panel] is. *)

(** {1 Vectors} *)

val across : side -> Vec3.t -> float
(** [across side v] is the component of [v] to the right. *)

val up : side -> Vec3.t -> float
(** [up side v] is the component of [v] upwards. *)

val towards_viewer : side -> Vec3.t -> float
(** [towards_viewer side v] is the component of [v] that a panel does not show.
*)

(** {1 Places} *)

val point : t -> Vec3.t -> Drawing.point
(** [point panel p] is where [panel] shows [p], or would if it were larger. *)

val middle : t -> Drawing.point
(** [middle panel] is the place in the middle of [panel]. *)

val shows : t -> Drawing.point -> bool
(** [shows panel place] is whether [place] is in [panel]. *)

val segment :
  t -> Vec3.t -> Vec3.t -> float -> (Drawing.point * Drawing.point) option
(** [segment panel origin direction length] is the part that [panel] shows of
    the line from [origin] along [direction] for [length], which may be
    [infinity]. [None] if that is nothing, or a single point. *)

val line : t -> Vec3.t -> Vec3.t -> (Drawing.point * Drawing.point) option
(** [line panel p direction] is {!segment} for the line without ends. *)
