(** Boxes: rectangles of pixels, of a picture or of a window. *)

open Raylab_drawing

type t = { left : int; top : int; width : int; height : int }
(** The type for boxes, from the left and from the top. A box may be empty. *)

val empty : t
(** [empty] has no pixel. *)

val is_empty : t -> bool
(** [is_empty box] is whether [box] has no pixel. *)

val contains : t -> int * int -> bool
(** [contains box (x, y)] is whether pixel [(x, y)] is in [box]. *)

val rectangle : t -> Rectangle.t
(** [rectangle box] is [box] as a part of a drawing. *)

val inter : t -> t -> t
(** [inter a b] is what [a] and [b] share. *)

val union : t -> t -> t
(** [union a b] is the smallest box around [a] and [b]; an empty one counts for
    nothing. *)
