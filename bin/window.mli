(** What the sub-commands that open a window share. *)

open Raylab_scene
open Raylab_window

val terminal : out_channel -> Terminal.t
(** [terminal channel] writes what was asked for to [channel] and messages to
    standard error. *)

val tell : string -> unit
(** [tell text] prints lines on standard error. *)

val check_size : Scene.t -> (unit, string) result
(** [check_size scene] is whether its picture fits into memory, or a message
    that says why not. *)

val load :
  string -> adjust:(Scene.t -> Scene.t) -> unit -> (Scene.t, string) result
(** [load path ~adjust ()] is [adjust] of the scene at [path], or the text of
    all that is wrong with it or with its size. *)

val source :
  ?out:string ->
  string ->
  load:(unit -> (Scene.t, string) result) ->
  Session.source
(** [source ~out path ~load] loads the scene by [load], and saves the picture
    to [out], by default beside [path] as BMP. *)

val on_loss : unit -> 'a
(** [on_loss ()] ends the program at once, successfully: the user has closed
    the window. *)
