(** A picture in a window, with the scene that it shows. *)

open Raylab_tracer
open Raylab_drawing

type t = {
  scene : Prepared.t;
  refinement : Refinement.t;
  first_row : int;
      (** its top row, counted from the top of the whole picture *)
}
(** The type for pictures that are shown. *)

val size : t -> int * int
(** [size shown] is width and height. *)

val background : int
(** [background] is the colour of what shows nothing, as [0xRRGGBB]. *)

val look : t list -> Raster.look
(** [look some] is, at each pixel, that of the first of [some], which have the
    same size, where something is known there; if there is none, the
    {!background}. *)

val explain : t -> int * int -> Explain.pixel
(** [explain shown (x, y)] explains pixel [(x, y)] of [shown]. *)

val overlay : t -> Explain.pixel -> Overlay.t
(** [overlay shown explanation] is the path of [explanation] over [shown]: the
    rays of one sample of each {!Raylab_explanation.Group}. *)
