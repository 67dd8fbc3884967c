(** The window: a picture that fills while it is rendered, and answers. *)

open Raylab_scene
open Raylab_tracer

type source = {
  name : string;  (** what the title calls the scene *)
  load : unit -> (Scene.t, string) result;
      (** reads the scene, on another domain; or says, in lines, why not *)
  can_save : unit -> (unit, string) result;
      (** whether [save] will work as far as is known now, or why not *)
  save : Picture.t -> string;
      (** saves the picture, and says where, or why it could not *)
}
(** The type for where scenes come from and pictures go. *)

(** The type for what there is to show at first. *)
type first =
  | Scene of Scene.t  (** it is rendered *)
  | Error of string  (** what is wrong with it is shown *)
  | Rendered of { scene : Prepared.t; picture : Picture.t; seconds : float }

val run :
  ?domains:int ->
  ?rows:Render.rows ->
  ?watch:Watch.t ->
  ?on_loss:(unit -> unit) ->
  terminal:Terminal.t ->
  source ->
  first ->
  (unit, string) result
(** [run ~terminal source first] opens a window and serves it until it is
    closed in any way, or goes away. No domain is left running then. It says in
    a line why there is no window if none can be opened.

    The window shows [first], of which [rows] are shown; see
    {!Raylab_tracer.Render}. Keys and clicks do what {!Raylab_viewer.Key.help}
    says. When [watch] tells of a change, the scene is read and rendered again,
    and a rendering under way is stopped.

    [on_loss] is called at once if the window is not closed from here, but is
    taken away, as most window managers do, or its display is. The X library
    may then hold a lock that a collection of garbage would wait for, if that
    happened in the middle of drawing: a program that has nothing else to do
    should end there, without further ado.

    Only the main domain may call this, and only one window can be open. If the
    display went away no other can be opened by this process. *)
