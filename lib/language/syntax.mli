(** Scenes as they are written: parsed, but no number checked yet. A setting
    may be missing or stand twice, a radius may be negative. {!Check.scene}
    makes a {!Raylab_scene.Scene.t} of it, or says what is wrong and where.

    A light or object only knows where it starts: a scene may have millions,
    and the places of single numbers are wanted only where one is in error. *)

open Raylab_geometry
open Raylab_scene

type 'a located = { value : 'a; span : Span.t }
(** A value and the text that it was read from. *)

type setting =
  | Image_width of float located
  | Image_height of float located
  | Canvas_width of float located
  | Canvas_height of float located
  | Depth of float located
  | Background of Color.t
  | Ray_depth of float located  (** A setting of the header. *)

type source = Directional of Vec3.t | Spherical of Vec3.t

type light = {
  source : source;
  intensity : float;
  color : Color.t;
  start : int;  (** the offset of the first byte *)
  line : int;  (** counted from 1 *)
}

type shape =
  | Sphere of { centre : Vec3.t; radius : float }
  | Plane of { point : Vec3.t; normal : Vec3.t }

type surface =
  | Diffusive of Color.t
  | Reflective
  | Luminous of Color.t
  | Mixed of (float * surface) list

type object_ = {
  shape : shape;
  surface : surface;
  start : int;  (** the offset of the first byte *)
  line : int;  (** counted from 1 *)
}

type t = {
  header : (Span.t * setting) list;  (** each with the span of its keyword *)
  header_end : Span.t;  (** the empty span after the last setting *)
  lights : light list;
  objects : object_ list;
}
(** The type for parsed scenes. *)
