(** Where an object or a light comes from. *)

(** The type for origins. A scene may have millions: one takes two words. *)
type t =
  | Unknown  (** from no file: it is made of values *)
  | Literal of int
      (** it is written out in a file, and starts at this offset; see
          {!Raylab_source.Files} *)

val offset : t -> int option
(** [offset origin] is where it is written, if that is known. *)
