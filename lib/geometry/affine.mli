(** Affine changes of space: whatever keeps straight lines straight and
    parallel ones parallel. *)

type t = private {
  xx : float;
  xy : float;
  xz : float;
  yx : float;
  yy : float;
  yz : float;
  zx : float;
  zy : float;
  zz : float;  (** the matrix, row by row *)
  x : float;
  y : float;
  z : float;  (** where the origin goes *)
}
(** The type for affine changes: [p] goes to [matrix * p + (x, y, z)]. *)

val identity : t
(** [identity] leaves everything where it is. *)

val stretched : Vec3.t -> t
(** [stretched k] multiplies each coordinate by that of [k]. *)

val rotated : axis:Direction.t -> sin:float -> cos:float -> t
(** [rotated ~axis ~sin ~cos] turns around [axis] through the origin by the
    angle of this sine and cosine, by the left-hand rule: with the left thumb
    along the axis, along the fingers (O. Rodrigues, 1840; in a left-handed
    frame his formula turns so). *)

val translated : Vec3.t -> t
(** [translated way] moves by [way]. *)

val compose : t -> t -> t
(** [compose second first] is [first], and then [second]. *)

val determinant : t -> float
(** [determinant a] is how many times as large [a] makes volumes; negative if
    it mirrors. *)

val inverse : t -> t option
(** [inverse a] undoes [a]; [None] if a number of [a] or of the result is not
    finite. *)

val point : t -> Vec3.t -> Vec3.t
(** [point a p] is where [a] puts the point [p]. *)

val vector : t -> Vec3.t -> Vec3.t
(** [vector a v] is the way that [a] makes of [v], the way from one point to
    another. *)

val covector : t -> Vec3.t -> Vec3.t
(** [covector a v] is [v] times the matrix of [a], from the left. Where [a] is
    the {!inverse} of a change, that is along the normal which the change makes
    of the normal [v], on the same side of the surface. *)

val size : t -> float
(** [size a] is a bound on how many times as long [a] makes a vector: the root
    of the sum of the squares of its matrix. *)

val numbers : t -> float array
(** [numbers a] is all numbers of [a]. *)

(** {1 On registers, for inner loops} *)

val bring : t -> Raw_ray.t -> float -> unit
(** [bring a ray length] puts [ray] where [a] puts it, with a direction of
    length 1 again. [length] is {!stretch}[ a ray]: so many times as large are
    distances along it. Its reach stays as it is. *)

val stretch : t -> Raw_ray.t -> float
(** [stretch a ray] is the length of what [a] makes of the direction of [ray].
*)

val bring_spot : out:t -> back:t -> Raw_ray.t -> Spot.t -> unit
(** [bring_spot ~out ~back ray spot] puts point and outward normal of [spot]
    where [out], whose inverse is [back], puts them; and makes its size what
    went into the point. Its own point stays. A normal that cannot be squared
    there is along [ray]. *)
