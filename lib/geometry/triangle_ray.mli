(** Rays as triangles of a mesh are tested for them: along an axis, from the
    origin.

    The axes are so named that the ray goes most along the third; a shear
    brings its direction on it (S. Woop, C. Benthin and I. Wald,
    {e Watertight ray/triangle intersection}, JCGT 2013). *)

type t
(** The type for such rays: a register. *)

val create : unit -> t
(** [create ()] is a new register, of no ray. *)

val set : t -> Raw_ray.t -> unit
(** [set sheared ray] makes [sheared] that of [ray]. *)

val meet : t -> float array -> int -> int -> int -> bool
(** [meet sheared points a b c] is whether the line of the ray goes through the
    triangle of these corners, places among [points]. If so, {!distance} tells
    where. Of triangles around an edge or a corner it goes through just one if
    they cover what is around it once. *)

val distance : t -> float
(** [distance sheared] is the distance from the ray's origin to where {!meet}
    last found one; negative behind it. *)
