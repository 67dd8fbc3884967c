(** Rays: [y = x + t d] for [0 < t < reach]. *)

type t = private Raw_ray.t
(** The type for rays. Nothing changes a ray once it is made. *)

val make : origin:Vec3.t -> direction:Direction.t -> t
(** [make ~origin ~direction] is the ray without end from [origin] along
    [direction]. Its seed is 0. *)

val towards : origin:Vec3.t -> target:Vec3.t -> short:float -> t option
(** [towards ~origin ~target ~short] is the ray from [origin] in the direction
    of [target] whose reach ends [short] before [target]; [None] if the two
    points coincide or are so far apart that no direction can be computed. *)

val of_raw : Raw_ray.t -> t
(** [of_raw register] is the ray that [register] holds now. The direction there
    must have length 1. *)

val to_raw : t -> Raw_ray.t
(** [to_raw ray] is a new register that holds [ray]. *)

val origin : t -> Vec3.t
(** [origin ray] is the point where [ray] starts. *)

val direction : t -> Direction.t
(** [direction ray] is the unit vector along [ray]. *)

val reach : t -> float
(** [reach ray] is the distance from which on hits do not count: [infinity]
    unless the ray goes {!towards} a point. *)

val seed : t -> float
(** [seed ray] is a number on which may depend what is placed at random for
    [ray]: a fixed function of pixel and sample for a ray of a picture, which
    the rays after it inherit; 0 for a ray that is made by hand. *)

val share : t -> float
(** [share ray] is how much [ray] counts in the colour of the ray from which it
    comes in the end: 1 of one that is made, and less of one that is sent on
    together with others. *)

val at : t -> float -> Vec3.t
(** [at ray t] is the point of [ray] at distance [t]. *)

val reflect : t -> point:Vec3.t -> normal:Direction.t -> t
(** [reflect ray ~point ~normal] is the ray without end from [point] in the
    direction of [ray] mirrored by a surface with this [normal]. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints [(0, 0, -4) + t (0, 0, 1)], followed by [, t < 3] if the ray
    has an end. *)
