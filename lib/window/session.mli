(** What goes on in a window: what it shows, and what keys and clicks do. *)

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

type t
(** The type for sessions. *)

val make :
  domains:int ->
  ?rows:Render.rows ->
  terminal:Terminal.t ->
  screen:(int * int) option ->
  picture:int * int ->
  source ->
  Canvas.t ->
  t
(** [make source canvas] is a session that shows nothing yet, with a window
    laid out for a [picture] of this size. *)

val show_whole : t -> Trace.t -> Picture.t -> first_row:int -> float -> unit
(** [show_whole session scene picture ~first_row seconds] shows a picture that
    is whole already, and took so many seconds. *)

val render : t -> unit
(** [render session] starts to read and render the scene. A rendering under way
    is stopped first. *)

val key : t -> Key.t -> [ `Go_on | `Close ]
(** [key session key] does what [key] is for. *)

val click : t -> int * int -> unit
(** [click session place] explains the pixel at this place of the window. *)

val step : t -> unit
(** [step session] takes note of what was rendered and of the size of the
    window, and draws what has changed. *)

val pause : t -> float
(** [pause session] is how long, in seconds, there may be no {!step} if there
    is no event: shortest while there is nothing to see yet. *)

val finish : t -> unit
(** [finish session] stops what is under way and waits for its end. *)
