(** Lights on the other side of a closed shape than the eye. *)

val warnings : Camera.t -> Light.t list -> Object.t list -> Warning.t list
(** [warnings camera lights objects] tells of each light that gives nothing to
    what the eye sees, since it is inside of a closed shape and the eye is not,
    or the other way round: every surface is opaque. A light that is about as
    near to a surface as rays start off it may be on both of its sides.

    Of very many lights and objects only some of the lights are looked at. *)
