(** What the sub-commands that open a window share. *)

open Raylab_scene
open Raylab_tracer
open Raylab_window

val check_size : Scene.t -> (unit, string) result
(** [check_size scene] is whether its picture fits into memory, or a message
    that says why not. *)

val load :
  allow:string list ->
  string ->
  ?watch:Watch.t ->
  ?on_read:(Raylab_language.Scene_file.reading -> unit) ->
  adjust:(Scene.t -> Scene.t) ->
  unit ->
  (Scene.t, string) result
(** [load ~allow path ~watch ~on_read ~adjust ()] is [adjust] of the scene at
    [path], or the text of all that is wrong with it or with its size. [watch]
    then follows all files that were read, or could not be, and [on_read], by
    default nothing, is done with what was read. *)

val source :
  ?out:string ->
  string ->
  load:(unit -> (Scene.t, string) result) ->
  View.source
(** [source ~out path ~load] loads the scene by [load], and saves the picture
    to [out], by default beside [path] as BMP. *)

val can_save : string -> (unit, string) result
(** [can_save path] is whether a picture can be saved at [path], as far as that
    is known before; see {!Raylab_picture.Atomic_file.check}. *)

val show :
  ?domains:int ->
  ?rows:Render.rows ->
  ?watch:Watch.t ->
  output:out_channel ->
  View.source ->
  View.first ->
  (unit, string) result
(** [show ~output source first] is {!Raylab_window.View.run}, with what was
    asked for on [output] and messages on standard error. A signal ends the
    program at once, also while the display does not answer; if the user takes
    the window away, or the display is lost, the program ends successfully. *)
