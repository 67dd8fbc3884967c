(** Discs: flat and round. *)

type t = private { centre : Vec3.t; normal : Direction.t; radius : float }
(** The type for discs: a centre whose coordinates are finite, a normal, and a
    radius that is finite and greater than 0. *)

val make : centre:Vec3.t -> normal:Direction.t -> radius:float -> t
(** [make ~centre ~normal ~radius] is the disc around [centre] perpendicular to
    [normal].

    Raises [Invalid_argument] if a number is not as it must be. *)

val name : string
(** [name] is the scene language's word, ["disc"]. *)

val parameters : t -> (string * Parameter.t) list
(** [parameters disc] is what is written after its word, in that order, each
    with its name: ["centre"], ["normal"] and ["radius"]. *)

val box : t -> Box3.t
(** [box disc] is a box around it: along each axis it reaches
    [radius * sqrt (1 - k^2)] far, with [k] the normal's number there. *)

(** {1 What is hit}

    The disc is the points [p] of a plane ({!Plane}) with
    [|p - centre| < radius]. *)

val offer : t -> Raw_ray.t -> Meeting.t -> number:int -> unit
(** [offer disc] is {!Shape.offer}. *)

val settle : t -> Raw_ray.t -> Spot.t -> unit
(** [settle disc] is {!Flat.settle}. *)

val crossings : t -> Raw_ray.t -> Crossings.t -> unit
(** [crossings disc] is {!Shape.crossings_raw}: none, or two at one distance.
*)

(** {1 What is told} *)

val place : t -> float array
(** [place disc] is numbers that say where [disc] is, whichever of its two
    normals it was made of. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints [disc centre (0, 0, 6) normal (0, 1, 0) radius 1]. *)
