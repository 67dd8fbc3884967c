(** Places in the files of a scene, as people are told of them. *)

type t = {
  file : string option;  (** printable; [None]: the main file *)
  line : int;  (** counted from 1 *)
}
(** The type for places. *)

val to_string : t -> string
(** [to_string place] is [line 30], or [line 3 of wood.scene] in another file
    than the main one. *)
