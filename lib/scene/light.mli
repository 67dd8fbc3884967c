(** Lights, as data. What they give to a point is told by
    {!Raylab_scene.Incidence}. *)

open Raylab_geometry

type source =
  | Directional of Direction.t  (** travels along this direction everywhere *)
  | Spherical of Vec3.t  (** shines from this point to all sides *)
  | Spot of Beam.t  (** shines from a point, but only into a cone *)
  | Area of Pane.t
      (** shines from all of a parallelogram, to all sides; of that, from one
          point of each of its cells *)

type t = private {
  source : source;
  intensity : float;
  color : Color.t;
  power : Color.t;  (** [intensity * color], at most [max_float] *)
  is_unfading : bool;  (** whether it is as strong far away as near *)
  origin : Origin.t;
}
(** The type for lights. *)

(** {1 Building}

    Raises [Invalid_argument] if [intensity] or a channel of [color] is
    negative or not finite, or a coordinate is not finite, or [direction] is
    the zero vector. *)

val directional : intensity:float -> color:Color.t -> direction:Vec3.t -> t
(** [directional ~intensity ~color ~direction] is light that travels along
    [direction], a vector of any length, as from a sun. *)

val spherical : intensity:float -> color:Color.t -> position:Vec3.t -> t
(** [spherical ~intensity ~color ~position] is light that shines from
    [position] to all sides and falls off with the square of the distance, as
    from a bulb.

    In a picture it gives nothing where that square is no double: beyond about
    1e154, where only an intensity of more than 1e304 could be seen, and within
    about 1e-162, as if the light were at the point itself. *)

val spot : intensity:float -> color:Color.t -> Beam.t -> t
(** [spot ~intensity ~color beam] is light that shines from the position of
    [beam] as a spherical one does, but only into its cone. *)

val area : intensity:float -> color:Color.t -> Pane.t -> t
(** [area ~intensity ~color pane] is light that shines from [pane]: the mean of
    spherical lights, each of [intensity], at its points. *)

val unfading : t -> t
(** [unfading light] is [light] without its fall-off with the distance: it
    gives everywhere what it would give at the distance 1. One that is
    directional never falls off. *)

val transformed : Change.t -> t -> t
(** [transformed change light] is [light] as [change] puts it; its intensity
    and angles stay. A direction goes where the way from one point to another
    would: light that goes through two points goes through both afterwards.

    Raises [Invalid_argument] if a point is no longer finite, a direction none,
    or the position of a spot that of its target. *)

(** {1 Where it shines from} *)

val points : t -> int
(** [points light] is from how many points it shines: those of its pane if it
    is an area light, else 1. *)

val places : t -> Vec3.t list
(** [places light] is where it is: its position, or the corners of its pane;
    nowhere if it is directional. *)

val fan : t -> Fan.source option
(** [fan light] is what all shadow rays to [light] have in common, if that is
    something. *)

(** {1 Forms} *)

val name : t -> string
(** [name light] is the scene language's word, such as ["spherical"]. *)

val parameters : t -> (string * Parameter.t) list
(** [parameters light] is what is written after intensity and colour, in that
    order, each with its name. *)

val with_origin : Origin.t -> t -> t
(** [with_origin origin light] is [light] with this origin, which at first is
    unknown. *)

val map_color : (Color.t -> Color.t) -> t -> t
(** [map_color f light] is [light] in the colour [f color].

    Raises [Invalid_argument] if [f] makes a colour that no light may have. *)

val equal : t -> t -> bool
(** [equal a b] is whether [a] and [b] have the same numbers. Origins do not
    count. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints
    [directional light, intensity 1, rgb 1 1 1, direction (0, -1, 0)] or
    [spherical light, intensity 1, rgb 1 1 1, position (0, 5, 0), unfading]. *)
