(** Files of the formats that hold rows one after another, BMP and PPM, piece
    by piece. *)

type t =
  | Bmp
      (** The lowest row first, from byte 54 on, where strict readers expect
          it. The label is the line after the pixels. *)
  | Ppm  (** The topmost row first. The label is a comment of the header. *)

val write : t -> Pixels.t -> out_channel -> unit
(** [write format pixels channel] writes [pixels] to [channel].

    Raises [Sys_error] if it cannot, and what [pixels.iter] raises. *)

(** {1 Parts of a file} *)

val header : t -> label:string option -> width:int -> height:int -> string
(** [header format ~label ~width ~height] is everything before the rows. *)

val trailer : t -> label:string option -> string
(** [trailer format ~label] is everything after them. *)

val label : t -> start:string -> stop:string -> string option
(** [label format ~start ~stop] is the label of a file that starts with [start]
    and ends with [stop], if it is all there. *)

(** {1 Rows} *)

val stride : t -> width:int -> int
(** [stride format ~width] is the number of bytes of a row. *)

val lowest_first : t -> bool
(** [lowest_first format] is whether files start with the lowest row. *)

val decode : t -> width:int -> bytes -> bytes
(** [decode format ~width bytes] is the red, green and blue bytes, from the
    topmost row on, of rows that follow each other in a file as [bytes]. It may
    be [bytes] itself. *)
