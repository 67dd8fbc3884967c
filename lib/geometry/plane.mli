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

val parts : t -> (string * Part.t) list
(** [parts plane] is what is written after its word, in that order, each part
    with its name: ["point"] and ["normal"]. *)

val intersections : t -> Ray.t -> float list
(** [intersections plane ray] is all [t], negative ones included, for which
    [Ray.at ray t] lies on [plane]: one, or none if the ray is parallel to the
    plane, inside it or not. The ray's reach is not looked at. *)

val nearest : t -> Ray.t -> float
(** [nearest plane ray] is the one of {!intersections} if it is greater than 0,
    and [infinity] otherwise. *)

val nearest_raw :
  float -> float -> float -> float -> float -> float -> Raw_ray.t -> float
(** [nearest_raw px py pz nx ny nz ray] is {!nearest} for the plane through
    (px, py, pz) with the unit normal (nx, ny, nz), for inner loops that keep
    planes as numbers. *)

val place : t -> float array
(** [place plane] is numbers that say where [plane] is, to about nine digits:
    the same whichever of its points and normals it was made of. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints [plane point (0, -1, 0) normal (0, 1, 0)]. *)
