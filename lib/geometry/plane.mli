(** Planes. *)

type t = private { point : Vec3.t; normal : Direction.t }
(** The type for planes: a point, all of whose coordinates are finite, and a
    normal. *)

val make : point:Vec3.t -> normal:Direction.t -> t
(** [make ~point ~normal] is the plane through [point] perpendicular to
    [normal].

    Raises [Invalid_argument] if a coordinate of [point] is not finite. *)

val name : string
(** [name] is the scene language's word, ["plane"]. *)

val parameters : t -> (string * Parameter.t) list
(** [parameters plane] is what is written after its word, in that order, each
    with its name: ["point"] and ["normal"]. *)

(** {1 What is hit}

    With [n] the normal and [p] the point, the line of a ray from [o] along [d]
    meets the plane at [(p - o) . n / d . n]; not at all if it is parallel to
    it, inside it or not. The inside is the side away from the normal. *)

val offer : t -> Raw_ray.t -> Meeting.t -> number:int -> unit
(** [offer plane] is {!Shape.offer}. *)

val settle : t -> Raw_ray.t -> Spot.t -> unit
(** [settle plane] is {!Shape.settle}: the spot is the end of the ray. *)

val crossings : t -> Raw_ray.t -> Crossings.t -> unit
(** [crossings plane] is {!Shape.crossings_raw}: one or none. *)

val depth : t -> Vec3.t -> float
(** [depth plane point] is how far inside [point] is, away from the normal;
    negative outside. *)

val place : t -> float array
(** [place plane] is numbers that say where [plane] is, to about nine digits:
    the same whichever of its points and normals it was made of. *)

val heading : Direction.t -> float array
(** [heading normal] is the first numbers of {!place}: the same for [normal]
    and for the opposite direction. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints [plane point (0, -1, 0) normal (0, 1, 0)]. *)
