(** CRC-32, the checksum that PNG files have: of ISO 3309, with the polynomial
    0xedb88320. *)

type t = private int
(** The type for checksums: from 0 to 2^32 - 1. *)

val empty : t
(** [empty] is the checksum of no bytes. *)

val add : t -> string -> t
(** [add crc text] is the checksum of the bytes of which [crc] is, followed by
    [text]. *)

val add_bytes : t -> bytes -> t
(** [add_bytes] is {!add} of bytes. *)

val to_hex : t -> string
(** [to_hex crc] is its eight hexadecimal digits, in lower case. *)
