(** Spheres. *)

type t = private { cx : float; cy : float; cz : float; radius : float }
(** The type for spheres: a centre and a radius greater than 0, all finite. *)

val make : centre:Vec3.t -> radius:float -> t
(** [make ~centre ~radius] is the sphere around [centre].

    Raises [Invalid_argument] if a number is not finite or [radius] is not
    greater than 0. *)

val name : string
(** [name] is the scene language's word, ["sphere"]. *)

val parts : t -> (string * Part.t) list
(** [parts sphere] is what is written after its word, in that order, each part
    with its name: ["centre"] and ["radius"]. *)

val centre : t -> Vec3.t
(** [centre sphere] is its centre. *)

val intersections : t -> Ray.t -> float list
(** [intersections sphere ray] is all [t], negative ones included and in
    ascending order, for which [Ray.at ray t] lies on [sphere]: none or two,
    which are equal where the line touches the sphere. The ray's reach is not
    looked at. From about 1e154 on squares overflow, and the sphere is not met.

    With [l] the vector from the point of the line that is nearest to the
    centre, the discriminant is computed as [r^2 - l . l]: the textbook's
    [b^2 - c] loses all digits for a small sphere far away (E. Haines and
    others, {e Precision improvements for ray/sphere intersection}, Ray Tracing
    Gems, 2019). *)

val nearest : t -> Ray.t -> float
(** [nearest sphere ray] is the least of {!intersections} that is greater than
    0, or [infinity] if there is none. *)

val nearest_raw : float -> float -> float -> float -> Raw_ray.t -> float
(** [nearest_raw x y z radius ray] is {!nearest} for the sphere of [radius]
    around (x, y, z), for inner loops that keep spheres as numbers. *)

val middle : float -> float -> float -> Raw_ray.t -> float
(** [middle x y z ray] is the distance at which [ray]'s line is nearest to (x,
    y, z): half way between the {!intersections} with a sphere around it. *)

val discriminant :
  float -> float -> float -> float -> Raw_ray.t -> float -> float
(** [discriminant x y z radius ray middle] is the square of half the distance
    between the {!intersections}, negative if there are none. [middle] is
    {!middle}. *)

val normal : t -> Vec3.t -> Direction.t
(** [normal sphere point] is the unit vector from the centre towards [point]:
    for a point of the sphere, the outward normal. The centre itself is given
    the direction of the y axis. *)

val depth : t -> Vec3.t -> float
(** [depth sphere point] is how far inside of [sphere] [point] is; negative
    outside. *)

val project : t -> Direction.t -> Vec3.t
(** [project sphere normal] is the point of [sphere] whose outward normal is
    [normal]. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints [sphere centre (0, 0, 6) radius 1]. *)
