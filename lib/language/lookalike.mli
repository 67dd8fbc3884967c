(** Strange characters in a text; see {!Raylab_source.Character}. *)

type t = {
  start : int;  (** the offset of its first byte *)
  stop : int;  (** the offset after its last byte *)
  name : string;  (** its code and its name: ["U+2212, a minus sign"] *)
  meant : string;
      (** what it was meant for: ["-"]; [" "] for a space, [""] for what is not
          seen, and the text itself of a byte that means nothing *)
}
(** The type for such characters in a text. *)

val first : string -> t option
(** [first text] is the first of them in [text]. A byte that is not UTF-8 is
    one as well. *)

val plain : string -> string
(** [plain text] is [text] with what was meant in place of each. *)
