(** Where lights and objects go: into the scene, or into a grouping. *)

open Raylab_source
open Raylab_scene

type t
(** The type for sinks. *)

val scene : unit -> t
(** [scene ()] is that of a scene, which as yet has nothing. *)

val grouping : Thing.grouping -> t
(** [grouping g] is that of such a grouping. *)

val add : t -> _ Raylab_expression.Value.run -> Span.t -> Thing.node -> unit
(** [add sink run span node] puts [node] after what is in [sink]. In a scene it
    becomes lights and objects where the modifiers around them put them; groups
    and modifiers are steps of [run] then. If they leave the range of numbers
    there, or [node] cannot be part of the solid that [sink] is of, it raises
    {!Raylab_expression.Fault.Found} at [span]. *)

val lights : t -> Light.t list
(** [lights sink] is the lights in a scene, in their order. *)

val objects : t -> Object.t list
(** [objects sink] is its objects, likewise. *)

val nodes : t -> Thing.node list
(** [nodes sink] is all that is in a grouping, likewise. *)
