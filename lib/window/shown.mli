(** A picture in a window, with the scene that it shows. *)

open Raylab_tracer

type t = {
  scene : Trace.t;
  refinement : Refinement.t;
  first_row : int;
      (** its top row, counted from the top of the whole picture *)
}
(** The type for pictures that are shown. *)

val size : t -> int * int
(** [size shown] is width and height. *)

val color : t list -> size:int * int -> x:int -> y:int -> int
(** [color some ~size ~x ~y] is the colour of pixel [(x, y)] in the first of
    [some] that has this [size] and where it is known; that of nothing if there
    is none. *)

val explain : t -> int * int -> Explain.t
(** [explain shown (x, y)] explains pixel [(x, y)] of [shown]. *)

val overlay : t -> Explain.t -> Path_overlay.t
(** [overlay shown explanation] is the path of [explanation] over [shown]. *)
