(** What is wrong with a file of a mesh, and where. *)

type place =
  | Line of int  (** of a text, counted from 1 *)
  | Byte of int  (** of a file of bytes, counted from 0 *)
  | Whole  (** the file as a whole *)

type t = { place : place; message : string }
(** The type for faults. [message] says what is wrong, without a full stop. *)

val to_string : t -> string
(** [to_string fault] is ["line 12: ..."], ["byte 84: ..."] or the message
    alone. *)

exception Found of t
(** What readers raise, inside this library only. *)

val fail : place -> ('a, unit, string, 'b) format4 -> 'a
(** [fail place "..." ...] raises {!Found}. *)
