(** Pictures as files take them: piece by piece, so that they need not be in
    memory as a whole. *)

open Raylab_tracer

type t = {
  width : int;
  height : int;
  label : string option;
      (** a line of ASCII that travels in the file, and that viewers do not
          show *)
  iter : lowest_first:bool -> (bytes -> int -> int -> unit) -> unit;
      (** [iter ~lowest_first f] calls [f rgb at length] for all rows, some at
          a time, from the topmost or from the lowest piece on. A piece is
          [length] bytes of [rgb] from [at] on: red, green and blue, row by
          row, the topmost of the piece first. *)
}
(** The type for pictures to be written. *)

val of_picture : Picture.t -> t
(** [of_picture picture] is [picture], without a label. *)
