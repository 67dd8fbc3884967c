(** Spans: pieces of the texts of a scene.

    All files of a scene lie in one space of offsets, one after another, so
    that an offset tells the file as well as the byte; see {!Files}. *)

type t = {
  start : int;  (** the offset of the first byte *)
  stop : int;  (** the offset after the last byte *)
}
(** The type for spans. A span may be empty, and lies in one file. *)
