(** Pictures: the pixels that a rendering fills. *)

open Raylab_scene

type t
(** The type for pictures: rows of red, green and blue bytes. Pixel [(x, y)] is
    the [x]-th from the left, of the [y]-th row from the top, both counted from
    0. *)

val create : width:int -> height:int -> t
(** [create ~width ~height] is a black picture of this size, three bytes a
    pixel.

    Raises [Invalid_argument] if [width] or [height] is less than 1, or there
    are more bytes than [Sys.max_string_length]. Whether they fit into memory
    is asked by [Picture_file.check_size]; if they do not, [Out_of_memory] is
    raised. *)

val unset : width:int -> height:int -> t
(** [unset ~width ~height] is likewise a picture to be filled: a pixel may have
    any colour until it is {!set}. So the first pixels of a large picture need
    not wait for memory that the last will need.

    Raises what {!create} raises. *)

val width : t -> int
(** [width picture] is the number of pixels in a row. *)

val height : t -> int
(** [height picture] is the number of rows. *)

val set : t -> x:int -> y:int -> Color.t -> unit
(** [set picture ~x ~y color] makes pixel [(x, y)] show [color]; see
    {!Raylab_scene.Level}. Domains may set different pixels at the same time.

    Raises [Invalid_argument] if there is no such pixel. *)

val get : t -> x:int -> y:int -> int * int * int
(** [get picture ~x ~y] is the red, green and blue byte of pixel [(x, y)].

    Raises [Invalid_argument] if there is no such pixel. *)

val code : t -> x:int -> y:int -> int
(** [code picture ~x ~y] is likewise one number, [0xRRGGBB]. *)

val to_rgb : t -> bytes
(** [to_rgb picture] is the bytes of [picture] themselves, not a copy: row by
    row from the top, three to a pixel. *)

val equal : t -> t -> bool
(** [equal a b] is whether [a] and [b] have the same size and pixels. *)
