(** Boxes with sides along the axes, as shapes. *)

type t = private { low : Vec3.t; high : Vec3.t }
(** The type for boxes, by the corners with the least and with the greatest
    coordinates, which are all finite and differ. *)

val make : corner:Vec3.t -> opposite:Vec3.t -> t
(** [make ~corner ~opposite] is the box between two opposite corners, whichever
    they are.

    Raises [Invalid_argument] if a coordinate is not finite, or is the same in
    both corners. *)

val name : string
(** [name] is the scene language's word, ["box"]. *)

val parameters : t -> (string * Parameter.t) list
(** [parameters box] is what is written after its word, in that order, each
    with its name: ["low"] and ["high"]. *)

val box : t -> Box3.t
(** [box b] is itself as a place. *)

(** {1 What is hit}

    The box is the points with [low <= p <= high] in each coordinate. Between
    two opposite faces, such as those across x, the line of a ray from [o]
    along [d] is from [(low - o) / d] to [(high - o) / d] or the other way
    round, and in the box while it is between all three pairs (T. L. Kay and J.
    T. Kajiya, {e Ray tracing complex scenes}, SIGGRAPH 1986). A line in a face
    is in the box, and so is one through an edge or a corner only.

    Faces are the parts: 0 and 1 those of least and greatest x, 2 and 3 of y, 4
    and 5 of z. At an edge the first of them is met. *)

val offer : t -> Raw_ray.t -> Meeting.t -> number:int -> unit
(** [offer box] is {!Shape.offer}. *)

val settle : t -> part:int -> Raw_ray.t -> Spot.t -> unit
(** [settle box] is {!Shape.settle}: the spot has exactly the coordinate of its
    face, and none beyond the face. *)

val crossings : t -> Raw_ray.t -> Crossings.t -> unit
(** [crossings box] is {!Shape.crossings_raw}: none or two. *)

val depth : t -> Vec3.t -> float
(** [depth box point] is how far inside of [box] [point] is; negative outside.
*)

(** {1 What is told} *)

val part : int -> string
(** [part k] is what part [k] is called, such as ["top"]. *)

val corners : t -> Vec3.t list
(** [corners box] is all eight. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints [box (-1, -1, 5) to (1, 1, 7)]. *)
