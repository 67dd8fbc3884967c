(** How a hand moves the eye of a scene, one picture after the other.

    The next picture is asked for when the one before is known everywhere, if
    coarsely: so what is seen follows the hand as fast as the machine can. *)

open Raylab_scene

type t
(** The type for what is known of the eye. *)

val start : t
(** [start] waits for a scene that is being read. *)

val viewpoint : t -> Viewpoint.t option
(** [viewpoint steering] is where the eye is; [None] before there is a scene.
*)

(** {1 What happens} *)

val ask : t -> t
(** [ask steering] waits for a scene that is being read. *)

val begin_ : Camera.t -> t -> t
(** [begin_ camera steering] is that the picture of [camera] begins which was
    asked for. If it is a scene's own and the one before had the same
    viewpoint, the eye stays where the hand has put it. *)

val fail : t -> t
(** [fail steering] is that nothing comes of what was asked for. *)

val move : Viewpoint.t -> t -> t
(** [move viewpoint steering] moves the eye. *)

val back : t -> t
(** [back steering] moves it to where the scene has it. *)

val next : is_covered:bool -> t -> t * Camera.t option
(** [next ~is_covered steering] is the camera of a picture that is to be begun
    now, if there is one, where the latest one [is_covered]: known everywhere.
    It is asked for then. *)

val is_under_way : t -> bool
(** [is_under_way steering] is whether the eye is elsewhere than in the picture
    that was begun last. *)

val is_view : t -> bool
(** [is_view steering] is whether the picture that was asked for last is one
    that follows the hand. *)
