(** The numbers in the body of a PLY file, one after another. *)

type t
(** The type for bodies that are being read. *)

val start : Ply_header.t -> string -> t
(** [start header bytes] is the body of [bytes], after its [header]. *)

val check : t -> Ply_header.element -> unit
(** [check rows element] is nothing. It is a fault if what is left of a file
    cannot hold all rows of [element]. *)

val start_row : t -> unit
(** [start_row rows] goes to the next row. *)

val end_row : t -> unit
(** [end_row rows] leaves it. It is a fault if more stands in its line. *)

val place : t -> Fault.place
(** [place rows] is the place of the last number. *)

val next : t -> Ply_header.scalar -> float
(** [next rows scalar] is the next number, of this type. It is a fault if there
    is none; it may be infinite or NaN. *)

val next_int : t -> Ply_header.scalar -> int
(** [next_int rows scalar] is {!next}, where that is a whole number; it is a
    fault if it has more than nine digits. *)
