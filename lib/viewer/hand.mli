(** The hand at the mouse: whether it clicks or drags. *)

type place = int * int
(** The type for places of the window. *)

type t
(** The type for what the hand is at. *)

val free : t
(** [free] holds no button. *)

val is_free : t -> bool
(** [is_free hand] is whether [hand] holds no button. *)

(** What it is that happened. *)
type gesture =
  | Nothing
  | Click of place  (** where the button went down *)
  | Drag of { across : int; down : int }
      (** how far the pointer is from there, to the right and downwards *)

val threshold : int
(** [threshold] is 4: so many pixels must a pointer move, across or down, with
    the button held, until that is a drag. *)

val press : place -> t
(** [press place] has just pressed the button at [place]. *)

val move : place -> t -> t * gesture
(** [move place hand] is [hand] with the pointer at [place], and the {!Drag}
    that this is part of, if it is of one. *)

val release : place -> t -> gesture
(** [release place hand] is what it was, once [hand] let the button go at
    [place]: the end of a {!Drag}, or a {!Click}. *)
