(** Headers of PLY files: what stands in the file after them. *)

type scalar =
  | Int8
  | Uint8
  | Int16
  | Uint16
  | Int32
  | Uint32
  | Float32
  | Float64

val bytes : scalar -> int
(** [bytes scalar] is how many bytes one takes. *)

type property =
  | Scalar of { name : string; item : scalar }
  | List of { name : string; count : scalar; item : scalar }

type element = {
  name : string;
  count : int;
  properties : property list;
  declared : Fault.place;  (** where the header says so *)
}
(** So many rows, each with a value or list for each property. *)

type format = Ascii | Little_endian | Big_endian

type t = {
  format : format;
  elements : element list;  (** in their order *)
  body : int;  (** the byte where the first row is *)
  body_line : int;  (** its line, counted from 1 *)
}
(** The type for headers. *)

val read : string -> t
(** [read bytes] is the header of [bytes]. Raises {!Fault.Found}. *)
