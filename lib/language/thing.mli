(** What names of a scene stand for beside numbers and texts. *)

open Raylab_geometry
open Raylab_expression
open Raylab_scene

(** The type for ways to put items together. *)
type grouping = Together  (** as a group *) | Solid of Solid.operation

(** The type for things. *)
type t =
  | Surface of Surface.t
  | Light of placeable
  | Object of placeable  (** also a group *)

and placeable = {
  node : node;
  born : int;
      (** how many steps of evaluation had been taken when it was made *)
}

(** The type for lights and objects, each in its own coordinates. *)
and node = private
  | Leaf of Object.t
  | Lamp of Light.t
  | Group of {
      grouping : grouping;
      origin : Origin.t;
      nodes : node list;
      size : size;
    }
  | Changed of { change : Change.t; node : node; size : size }
  | Named of { named : named; node : node; size : size }
      (** placed by its name *)
  | Shadowless of { node : node; size : size }
  | Unfading of { node : node; size : size }

and size = {
  count : int;  (** lights and objects *)
  visits : int;  (** nodes, at most a billion: what it takes to place it *)
  depth : int;  (** how deep groupings nest *)
  shines : bool;  (** whether there is a light among them *)
  unfit : unfit option;  (** {!val-unfit} of a node that is more than one *)
}

and unfit = {
  what : string;  (** such as ["a light"] *)
  why : string;  (** such as ["has no inside"] *)
  advice : string;
}
(** Why something cannot be part of a solid. *)

and named = { name : string; at : int; within : Trail.t }
(** The type for names as they stand: at this offset, evaluated there. *)

val leaf : Object.t -> node
(** [leaf o] is the object [o]. *)

val lamp : Light.t -> node
(** [lamp l] is the light [l]. *)

val again : Trail.t -> node -> node
(** [again within node] is [node], which is written out, made in a call or a
    round. *)

val word : grouping -> string
(** [word grouping] is the scene language's word for it. *)

val a : string -> string
(** [a word] is [word], such as that of a grouping, after an article. *)

val group : origin:Origin.t -> grouping -> node list -> node
(** [group ~origin grouping nodes] is these together. *)

val changed : Change.t -> node -> node
(** [changed change node] is [node] as [change] puts it. *)

val named : named -> node -> node
(** [named named node] is [node], placed by this name. *)

val shadowless : node -> node
(** [shadowless node] is [node], which shadow rays do not meet. *)

val unfading : node -> node
(** [unfading node] is [node], whose lights do not fall off. *)

val size : node -> size
(** [size node] is how large it is, in constant time. *)

val unfit : node -> unfit option
(** [unfit node] is why [node] cannot be part of a solid; [None] if it can. *)

val describe : t -> string
(** [describe thing] is what it is: ["a surface"]. *)
