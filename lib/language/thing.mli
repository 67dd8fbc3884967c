(** What names of a scene stand for beside numbers and texts. *)

open Raylab_geometry
open Raylab_scene

(** The type for things. *)
type t =
  | Surface of Surface.t
  | Light of node
  | Object of node  (** also a group *)

and node =
  | Leaf of Object.t
  | Lamp of Light.t
  | Many of { nodes : node list; count : int }
  | Changed of Change.t * node
      (** The type for lights and objects, each in its own coordinates. *)

val many : node list -> node
(** [many nodes] is these together. *)

val count : node -> int
(** [count node] is how many lights and objects it has, in constant time. *)

val describe : t -> string
(** [describe thing] is what it is: ["a surface"]. *)
