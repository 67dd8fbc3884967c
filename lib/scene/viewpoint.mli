(** Where an eye is, and where it looks: the frame in which a camera sees.

    The frame is left-handed, as the scene's is: in it x goes to the right, y
    up and z away from the eye. *)

open Raylab_geometry

type t = private {
  eye : Vec3.t;
  look_at : Vec3.t;  (** the point that is seen in the middle of the picture *)
  up : Vec3.t;  (** what is up in the picture, as far as it can be *)
  right : Direction.t;
      (** the frame: at right angles, as far as rounding goes *)
  above : Direction.t;
  forward : Direction.t;
}
(** The type for viewpoints: every number is finite. With
    [f = unit (look_at - eye)] and [r = unit (up x f)], [right] is [r], [above]
    is [f x r], and [forward] is [f]. *)

(** The type for what is wrong with a viewpoint. *)
type problem =
  | At_the_eye  (** [look_at] is [eye]: there is no direction to look in *)
  | Along_up  (** [up] and the way to [look_at] differ by less than 1e-9 *)

val make : ?look_at:Vec3.t -> ?up:Vec3.t -> Vec3.t -> (t, problem) result
(** [make ~look_at ~up eye] is the viewpoint at [eye]; [look_at] is the origin
    and [up] is (0, 1, 0) unless given.

    Raises [Invalid_argument] if a number is not finite, or [up] is zero. *)

val make_exn : ?look_at:Vec3.t -> ?up:Vec3.t -> Vec3.t -> t
(** [make_exn ~look_at ~up eye] is {!make}, and raises [Invalid_argument] where
    that finds a problem. *)

val before_origin : float -> t
(** [before_origin depth] is the viewpoint of a camera that is not placed: at
    (0, 0, -[depth]). Its frame is that of the scene, exactly. *)

val default_look_at : Vec3.t
(** [default_look_at] is the origin. *)

val default_up : Vec3.t
(** [default_up] is (0, 1, 0). *)

val distance : t -> float
(** [distance viewpoint] is how far the eye is from what it looks at;
    [infinity] where that is no double. *)

val to_frame : t -> Vec3.t -> Vec3.t
(** [to_frame viewpoint v] is the vector [v] in the frame: how far it goes to
    the right, up and away. *)

val of_frame : t -> Vec3.t -> Vec3.t
(** [of_frame viewpoint v] is the vector [v] of the frame in the scene: the
    inverse of {!to_frame}. *)

val equal : t -> t -> bool
(** [equal a b] is whether eye, point and up are the same. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints the eye, the point, and up where it is not {!default_up}. *)
