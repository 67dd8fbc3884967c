(** Ways of an eye around the point at which it looks.

    Its coordinates come out short, as people write them, and so the view that
    one sees is the one that is printed. *)

open Raylab_scene

val turn : across:float -> down:float -> Viewpoint.t -> Viewpoint.t
(** [turn ~across ~down viewpoint] is [viewpoint] after a hand has dragged what
    is seen to the right, by the part [across] of the picture's width, and
    down, by the part [down] of its height: all of either is half a turn. It
    comes no nearer to [up] than {!least_angle}, from above or below, unless it
    is there already. *)

val least_angle : float
(** [least_angle] is 1, in degrees. *)

val nearer : float -> Viewpoint.t -> Viewpoint.t
(** [nearer factor viewpoint] is [viewpoint] with the eye so many times as
    near: farther, if [factor] is less than 1. *)

val settings : Viewpoint.t -> string
(** [settings viewpoint] is the settings of the scene language that make it:
    [eye 3 2 -4   lookAt 0 0 0], and [up] unless it is the usual one. *)
