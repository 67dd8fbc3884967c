open Raylab_geometry
open Raylab_scene

type 'a located = { value : 'a; span : Span.t }
(** A value and the text that it was read from. *)

type number = float located
type vector = Vec3.t located

type color = Color.t located
(** Three numbers or a name. *)

type setting =
  | Image_width of number
  | Image_height of number
  | Canvas_width of number
  | Canvas_height of number
  | Depth of number
  | Background of color
  | Ray_depth of number  (** A setting of the header. *)

type source = Directional of vector | Point of vector

type light = {
  source : source;
  intensity : number;
  color : color;
  line : int;  (** counted from 1 *)
}

type shape =
  | Sphere of { centre : vector; radius : number }
  | Plane of { point : vector; normal : vector }

type surface =
  | Diffusive of color
  | Reflective
  | Luminous of color
  | Mixed of (number * surface) list

type object_ = {
  shape : shape;
  surface : surface;
  line : int;  (** counted from 1 *)
}

type t = {
  header : (Span.t * setting) list;  (** each with the span of its keyword *)
  header_end : Span.t;  (** the empty span after the last setting *)
  lights : light list;
  objects : object_ list;
}
(** The type for parsed scenes. *)
