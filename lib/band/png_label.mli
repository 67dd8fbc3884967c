(** Labels in PNG files: the text of a chunk tEXt, with the keyword Comment,
    that is the second chunk of the file. *)

val insert : string -> string -> string
(** [insert label png] is the PNG file [png] with [label] in it. *)

val find : string -> string option
(** [find start] is the label of a PNG file that starts with [start], if it has
    one that ends in [start]. *)

val is_whole : string -> width:int -> height:int -> bool
(** [is_whole png ~width ~height] is whether [png] is a PNG file of this size,
    with 24 bits a pixel, whose chunks are all there and have the checksums
    that they should have. *)
