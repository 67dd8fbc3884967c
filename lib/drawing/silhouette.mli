(** How a shape is drawn in a picture of a path. *)

open Raylab_geometry

type look = {
  fill : string;  (** its colour, as CSS has it *)
  is_met : bool;  (** whether the path meets it *)
}
(** The type for what decides on the style. *)

val draw :
  View.t -> look -> level:float -> Outline.t -> (Svg.t * View.point) option
(** [draw view look ~level outline] is the drawing of [outline] and the place
    where its label belongs. A ball is a circle, a piece of a plane a polygon;
    a plane without end is the line in which it cuts the plane of the view at
    [level]. [None] if nothing of it can be drawn in the panel. *)
