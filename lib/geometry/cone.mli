(** Cones and what is left of them without their tips, closed at both ends. *)

type t = private Frustum.t
(** The type for cones: the solids of {!Frustum}, where their mathematics is.
*)

val make : Vec3.t -> float -> Vec3.t -> float -> t
(** [make a radius_a b radius_b] is the cone around the way from [a] to [b]
    with these radii there; 0 makes a tip.

    Raises [Invalid_argument] if a number is not finite, a radius is negative,
    both are 0, or [a] is [b]. *)

val name : string
(** [name] is the scene language's word, ["cone"]. *)

val parameters : t -> (string * Parameter.t) list
(** [parameters cone] is what is written after its word, in that order, each
    with its name: ["a"], ["radius_a"], ["b"] and ["radius_b"]. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints [cone from (0, 0, 0) radius 1 to (0, 2, 0) radius 0]. *)
