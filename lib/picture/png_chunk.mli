(** Chunks, of which PNG files are made. *)

val signature : string
(** [signature] is what a file starts with. *)

val put : out_channel -> string -> string -> unit
(** [put channel name data] writes a chunk. *)

val most_data : int
(** [most_data] is about how many bytes of pixels there are in a chunk: few, so
    that no reader needs much memory. *)

exception Damaged
(** Raised where a file is not as raylab writes it. *)

val next : in_channel -> string * string
(** [next channel] is the name and the data of the chunk that follows.

    Raises {!Damaged} if its checksum is wrong, or if it is longer than those
    that raylab writes, and [End_of_file] if it is not all there. *)

(** {1 The first two} *)

val header : width:int -> height:int -> string
(** [header ~width ~height] is the data of the chunk IHDR, the first: of a
    picture with 24 bits a pixel that is not interlaced. *)

val text : string -> string
(** [text label] is the data of a chunk tEXt that holds [label]. *)

val label : string -> string option
(** [label start] is the label in the second chunk of a file that starts with
    [start], if all of it is there. *)
