(** Spheres. *)

type t = private { cx : float; cy : float; cz : float; radius : float }
(** The type for spheres: a centre and a radius greater than 0, all finite. *)

val make : centre:Vec3.t -> radius:float -> t
(** [make ~centre ~radius] is the sphere around [centre].

    Raises [Invalid_argument] if a number is not finite or [radius] is not
    greater than 0. *)

val name : string
(** [name] is the scene language's word, ["sphere"]. *)

val parameters : t -> (string * Parameter.t) list
(** [parameters sphere] is what is written after its word, in that order, each
    with its name: ["centre"] and ["radius"]. *)

val centre : t -> Vec3.t
(** [centre sphere] is its centre. *)

val box : t -> Box3.t
(** [box sphere] is the box that touches it on six sides. *)

val box_through : Affine.t -> t -> Box3.t
(** [box_through out sphere] is the box that touches the ellipsoid which [out]
    makes of [sphere] on six sides. *)

val rim : t -> Vec3.t list
(** [rim sphere] is some hundred points all over it, for drawings. *)

(** {1 What is hit}

    With [m] the place on the ray's line that is nearest to the centre, and [l]
    the vector from there to the centre, the line meets the sphere at
    [m - sqrt (r^2 - l . l)] and [m + sqrt (r^2 - l . l)], which are equal
    where it touches the sphere. The textbook's [b^2 - c] loses all digits for
    a small sphere far away (E. Haines and others,
    {e Precision improvements for ray/sphere intersection}, Ray Tracing Gems,
    2019). From about 1e154 on squares overflow, and the sphere is not met. *)

val middle : float -> float -> float -> Raw_ray.t -> float
(** [middle x y z ray] is the distance [m] at which [ray]'s line is nearest to
    (x, y, z). *)

val discriminant :
  float -> float -> float -> float -> Raw_ray.t -> float -> float
(** [discriminant x y z radius ray middle] is [r^2 - l . l] for a sphere around
    (x, y, z), negative if the line does not meet it. [middle] is {!middle}. *)

val offer : t -> Raw_ray.t -> Meeting.t -> number:int -> unit
(** [offer sphere] is {!Shape.offer}. *)

val offer_row :
  float array -> int -> Raw_ray.t -> Meeting.t -> number:int -> unit
(** [offer_row rows place ray meeting ~number] is {!offer} for the sphere whose
    x, y, z and radius are in [rows] from [4 * place] on, for inner loops that
    keep spheres as numbers. *)

val settle : t -> Raw_ray.t -> Spot.t -> unit
(** [settle sphere] is {!Shape.settle}: the spot is the point of the sphere
    that is nearest to the end of the ray, with the normal from the centre
    towards it. At the centre itself the normal is along the ray. *)

val crossings : t -> Raw_ray.t -> Crossings.t -> unit
(** [crossings sphere] is {!Shape.crossings_raw}: none or two. *)

val depth : t -> Vec3.t -> float
(** [depth sphere point] is how far inside of [sphere] [point] is; negative
    outside. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints [sphere centre (0, 0, 6) radius 1]. *)
