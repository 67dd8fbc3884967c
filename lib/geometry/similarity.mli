(** Changes of place and size that keep every shape what it is. *)

type t
(** The type for similarities: larger or smaller, then turned, then moved. *)

val identity : t
(** [identity] leaves everything where it is. *)

val scaled : float -> t
(** [scaled k] makes all [k] times as large, seen from the origin; [k > 0]. *)

val rotated : axis:Direction.t -> sin:float -> cos:float -> t
(** [rotated ~axis ~sin ~cos] turns around [axis] through the origin by the
    angle of this sine and cosine, by the left-hand rule: with the left thumb
    along the axis, along the fingers (O. Rodrigues, 1840; in a left-handed
    frame his formula turns so). *)

val translated : Vec3.t -> t
(** [translated way] moves by [way]. *)

val compose : t -> t -> t
(** [compose second first] is [first], and then [second]. *)

val factor : t -> float
(** [factor s] is how many times as large [s] makes all. *)

val point : t -> Vec3.t -> Vec3.t
(** [point s p] is where [s] puts the point [p]. *)

val direction : t -> Vec3.t -> Vec3.t
(** [direction s v] is [v] turned as [s] turns, as long as it was. *)

val keeps_axes : t -> bool
(** [keeps_axes s] is whether [s] puts what lies along an axis along an axis,
    as a turn by 90 degrees around one does. *)
