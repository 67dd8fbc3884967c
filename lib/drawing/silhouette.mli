(** How a shape is drawn in a panel. *)

open Raylab_geometry

type t = {
  fill : Drawing.color;
  is_met : bool;  (** whether the path meets it *)
}
(** The type for what decides on the look. *)

val draw :
  Panel.t ->
  t ->
  level:float ->
  Outline.t ->
  (Drawing.mark list * Drawing.point) list
(** [draw panel s ~level outline] is the drawing of each piece of [outline] and
    the place where its label belongs. A ball is a circle, a piece of a plane
    or of a body a polygon; a plane without end is the line in which it cuts
    the plane of the panel at [level]. Nothing if nothing of it can be drawn in
    the panel. *)
