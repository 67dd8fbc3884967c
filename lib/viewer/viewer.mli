(** What a window or a page shows, and what keys and clicks do there.

    A viewer is told what happens, and says what is to be done and to be seen:
    a shell around it does that, and has the window or the page, the time, the
    files and the domains. *)

open Raylab_tracer
open Raylab_drawing

type t
(** The type for viewers. Only the latest one counts: pictures and {!image}s
    are the same in all that came from one {!make}, and are filled again. *)

val make :
  name:string ->
  screen:(int * int) option ->
  window:int * int ->
  picture:int * int ->
  t
(** [make ~name ~screen ~window ~picture] shows nothing yet of the scene that
    titles call [name], in a window of the size [window] on this [screen], laid
    out for a [picture] of this size. *)

(** {1 What happens} *)

type event =
  | Pressed of char  (** a key *)
  | Button_down of int * int  (** at a place of the window *)
  | Pointer_at of int * int  (** while the button is held *)
  | Button_up of int * int
  | Resized of int * int  (** the window has this width and height *)
  | Changed  (** what the scene is read from *)
  | News of Rendering.news
  | Saving_checked of (unit, string) result
      (** the answer to {!Check_saving}: it will work, or why not *)
  | Saved of string  (** the answer to {!Save}: where, or why not *)
  | Rendered of Shown.t * float
      (** a picture, whole at once, which took so many seconds *)

(** What is to be done. *)
type request =
  | Render  (** read the scene and render it, anew if that is under way *)
  | Look of Prepared.t
      (** render this, the scene from where the hand has put the eye; anew if
          something is under way *)
  | Check_saving  (** find out whether {!Save} will work *)
  | Save of Picture.t
  | Print of string  (** lines that were asked for *)
  | Tell of string  (** a message *)
  | Explain of Explain.pixel  (** why a pixel is so *)
  | Resize of int * int
      (** the window to this width and height, if possible *)

val step : t -> event -> t * request list
(** [step viewer event] is [viewer] after [event], and what is to be done for
    it, in this order. *)

val is_holding : t -> bool
(** [is_holding viewer] is whether a button is held, so that it matters where
    the pointer is. *)

val is_closed : t -> bool
(** [is_closed viewer] is whether a key has closed it. *)

(** {1 What is to be seen} *)

val title : t -> string
(** [title viewer] is the title of the window. *)

val shows_something : t -> bool
(** [shows_something viewer] is whether any pixel is there to be seen. *)

type image = {
  box : Box.t;  (** the part of the window that has changed *)
  rows : int array array option;
      (** its rows in the whole width of the window, as [0xRRGGBB]; none where
          all of it is {!Shown.background} *)
  over : Drawing.t;  (** over all of the window *)
}
(** The type for what a window is to show. *)

val draw : text_size:(string -> float * float) -> t -> t * image option
(** [draw ~text_size viewer] is [viewer] once it was drawn, and what has
    changed to be seen since it was drawn last; [None] if nothing. A line of
    words has the width and the height [text_size words], and letters are
    equally wide. *)
