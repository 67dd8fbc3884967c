(** What a cell of a fan knows of a shape that may be seen through it, in one
    number: its depth, its place among the leaves, and a disc, in parts of the
    cell. Numbers of what is nearer are less.

    It takes 62 bits. Where an [int] has fewer there are no fans. *)

val most_places : int
(** [most_places] is how many places there may be at most. *)

(** {1 Depth} *)

val slices : int
(** [slices] is into how many slices the depth of all shapes is cut. *)

val beyond : float -> int
(** [beyond d] is more than the reference of everything that begins before the
    depth [d], in slices; NaN is as good as infinite. *)

(** {1 Discs} *)

val units : int
(** [units] is how many units of a disc are as long as a cell. *)

val fine : float
(** [fine] is the same number. *)

val far : int
(** [far] is a place, in units, farther off than any disc that is known. *)

val make : slice:float -> place:int -> u:int -> v:int -> radius:float -> int
(** [make ~slice ~place ~u ~v ~radius] is the reference of a shape that begins
    in [slice] of the depth, and lies in the disc with the middle (u, v), in
    units from the first corner of the cell, each rounded to the nearest, and
    this radius, in units. *)

val place : int -> int
(** [place reference] is the place among the leaves. *)

val may_be_at : int -> int -> int -> bool
(** [may_be_at reference u v] is whether the disc may hold the point (u, v), in
    units from the first corner of the cell, each rounded to the nearest. *)
