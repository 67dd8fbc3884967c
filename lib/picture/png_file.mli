(** PNG files, piece by piece: plain ones, of 24 bits a pixel and not
    interlaced. *)

val write : Pixels.t -> out_channel -> unit
(** [write pixels channel] writes [pixels] to [channel]. The label is the text
    of a chunk tEXt with the keyword Comment, the second chunk of the file.

    Raises [Sys_error] if it cannot, and what [pixels.iter] raises. *)

val label : string -> string option
(** [label start] is the label of a file that starts with [start], if all of
    that is there. *)

val read : in_channel -> width:int -> height:int -> bytes option
(** [read channel ~width ~height] is the red, green and blue bytes, row by row
    from the topmost, of a picture of this size that {!write} has written, or
    [None] if anything in the file is not as it writes it: it reads no other
    PNG. *)
