(** Cylinders, closed at both ends. *)

type t = private Frustum.t
(** The type for cylinders: those solids of {!Frustum}, where their mathematics
    is, whose two radii are equal. *)

val make : Vec3.t -> Vec3.t -> radius:float -> t
(** [make a b ~radius] is the cylinder around the way from [a] to [b].

    Raises [Invalid_argument] if a number is not finite, [radius] is not
    greater than 0, or [a] is [b]. *)

val name : string
(** [name] is the scene language's word, ["cylinder"]. *)

val parameters : t -> (string * Parameter.t) list
(** [parameters cylinder] is what is written after its word, in that order,
    each with its name: ["a"], ["b"] and ["radius"]. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints [cylinder from (0, 0, 0) to (0, 2, 0) radius 1]. *)
