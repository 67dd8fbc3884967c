(** Shapes: what an object of a scene looks like, without its surface.

    A new shape is a module of its own like {!module-Sphere}, a constructor
    here, and a case in each function below that the compiler asks for; see
    [doc/adding-a-shape.md]. Nothing else that renders or explains a scene
    knows which shapes there are, but for the hierarchy and the evaluator,
    which have a quicker way for spheres. *)

type t = Sphere of Sphere.t | Plane of Plane.t  (** The type for shapes. *)

val sphere : centre:Vec3.t -> radius:float -> t
(** [sphere ~centre ~radius] is {!Sphere.make} as a shape. *)

val plane : point:Vec3.t -> normal:Vec3.t -> t
(** [plane ~point ~normal] is {!Plane.make} as a shape; [normal] may have any
    length.

    Raises [Invalid_argument] if a coordinate is not finite or [normal] is the
    zero vector. *)

(** {1 What is hit} *)

val intersections : t -> Ray.t -> float list
(** [intersections shape ray] is all distances [t], in ascending order, at
    which the line of [ray] meets [shape]; negative ones lie behind the ray's
    origin. The ray's reach is not looked at. *)

val nearest : t -> Ray.t -> float
(** [nearest shape ray] is the least of {!intersections} that is greater than
    0, or [infinity] if there is none. *)

val nearest_raw : t -> Raw_ray.t -> float
(** [nearest_raw shape ray] is {!nearest} for a ray in a register. *)

val normal : t -> Vec3.t -> Direction.t
(** [normal shape point] is the unit normal of [shape] at [point], a point of
    [shape]: outward for a sphere, as given for a plane. *)

val normal_raw : t -> float -> float -> float -> Direction.t
(** [normal_raw shape x y z] is {!normal} at (x, y, z), for inner loops. *)

val depth : t -> Vec3.t -> float
(** [depth shape point] is how far inside of [shape] [point] is, negative
    outside; [neg_infinity] for a shape that is not closed. Each way from a
    point inside to one outside hits [shape]. *)

val ball : t -> Sphere.t option
(** [ball shape] is a sphere that holds all of [shape], the smaller the better;
    [None] if there is none, since [shape] has no end. *)

(** {1 What is told} *)

val name : t -> string
(** [name shape] is the scene language's word for it: ["sphere"], ["plane"]. *)

val parts : t -> (string * Part.t) list
(** [parts shape] is what the scene language writes after {!name}, in that
    order, each part with its name. *)

val outline : t -> Outline.t
(** [outline shape] is how [shape] is drawn and spoken of. *)

val equal : t -> t -> bool
(** [equal a b] is whether [a] and [b] are the same shape with the same
    numbers. *)

val place : t -> float array
(** [place shape] is numbers that are the same for shapes that fill the same
    place, and, as far as about nine digits reach, for no others. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints [sphere centre (0, 0, 6) radius 1] and
    [plane point (0, -1, 0) normal (0, 1, 0)]. *)
