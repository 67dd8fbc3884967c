(** Where an object or a light comes from. Offsets are those of
    {!Raylab_source.Files}. *)

open Raylab_expression

(** The type for origins. A scene may have millions: one that is written out
    takes two words, and those that a call or a round makes share what they
    know of it. *)
type t =
  | Unknown  (** from no file: it is made of values *)
  | Literal of int
      (** it is written out in a file, and starts at this offset *)
  | Made of { at : int; within : Trail.t }
      (** what is written there was evaluated in these calls and rounds *)
  | Placed of { at : int; within : Trail.t; placed : placed }
      (** and then it was placed by its name *)

(** The type for how what has a name was placed, the innermost first. *)
and placed =
  | At_once  (** where it was made *)
  | By_name of {
      name : string;
      at : int;  (** where its name stands *)
      within : Trail.t;
      around : placed;  (** of the group in which that is *)
    }

val offset : t -> int option
(** [offset origin] is where it is written, if that is known. *)

val make : at:int -> within:Trail.t -> t
(** [make ~at ~within] is what is made at once. *)

val again : Trail.t -> t -> t
(** [again within origin] is what is written out at [origin], made in a call or
    a round. *)

val place : placed -> t -> t
(** [place placed origin] is [origin], which has not been placed yet, placed
    so. *)
