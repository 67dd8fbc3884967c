(** What names of a scene stand for beside numbers and texts. *)

open Raylab_geometry
open Raylab_expression
open Raylab_scene

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
  | Many of { nodes : node list; size : size }
  | Changed of { change : Change.t; node : node; size : size }
  | Named of { named : named; node : node; size : size }
      (** placed by its name *)

and size = {
  count : int;  (** lights and objects *)
  visits : int;  (** nodes, at most a billion: what it takes to place it *)
}

and named = { name : string; at : int; within : Trail.t }
(** The type for names as they stand: at this offset, evaluated there. *)

val leaf : Object.t -> node
(** [leaf o] is the object [o]. *)

val lamp : Light.t -> node
(** [lamp l] is the light [l]. *)

val again : Trail.t -> node -> node
(** [again within node] is [node], which is written out, made in a call or a
    round. *)

val many : node list -> node
(** [many nodes] is these together. *)

val changed : Change.t -> node -> node
(** [changed change node] is [node] as [change] puts it. *)

val named : named -> node -> node
(** [named named node] is [node], placed by this name. *)

val size : node -> size
(** [size node] is how large it is, in constant time. *)

val describe : t -> string
(** [describe thing] is what it is: ["a surface"]. *)
