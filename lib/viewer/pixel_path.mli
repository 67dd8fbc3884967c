(** What is shown of a pixel that was clicked: its path, and why it is so. *)

open Raylab_tracer
open Raylab_drawing

type t = {
  pixel : int * int;
  sentence : string;  (** why it has its colour *)
  overlay : Overlay.t;
  is_visible : bool;
}
(** The type for such paths, which may be hidden for a while. *)

val make : Shown.t -> int * int -> Explain.pixel -> is_visible:bool -> t
(** [make shown pixel explanation ~is_visible] is the path of [explanation],
    which is that of [pixel] of [shown]. *)

val draw : text_size:(string -> float * float) -> Layout.t -> t -> Drawing.t
(** [draw ~text_size layout path] is [path], if it is visible, over a picture
    that is laid out so, with its sentence and with what its lines mean.
    [text_size] is as for {!Raylab_drawing.Legend.in_corner}. *)
