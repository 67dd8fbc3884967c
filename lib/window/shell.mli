(** The shell around a viewer: it tells the viewer what happens in the window,
    and does what that asks for. *)

open Raylab_tracer
open Raylab_viewer

type t = {
  canvas : Canvas.t;
  terminal : Terminal.t;
  renderer : Renderer.t;
  render : unit -> Rendering.t;  (** reads the scene and renders it *)
  look : Prepared.t -> Rendering.t;  (** renders this *)
  can_save : unit -> (unit, string) result;
      (** whether [save] will work as far as is known now, or why not *)
  save : Picture.t -> string;
      (** saves a picture, and says where, or why it could not *)
  has_changed : unit -> bool;
      (** is whether the scene has changed since the last question *)
}
(** The type for shells. *)

val serve : t -> Viewer.t -> Viewer.event -> unit
(** [serve shell viewer first] serves [viewer], to which [first] happens, until
    it is closed or the window is gone. *)
