(** Directions: vectors of length 1, which nothing else can build. *)

type t = private Vec3.t
(** The type for vectors whose length is 1 within rounding. Read one as a
    vector with [(d :> Vec3.t)]. *)

val of_vec3 : Vec3.t -> t option
(** [of_vec3 v] is the direction of [v], or [None] if [v] is the zero vector or
    has a component that is not finite. Components from the smallest double to
    the largest are all right. A vector that already has length 1 within
    rounding is left as it is, so that [of_vec3] changes no direction. *)

val of_vec3_exn : Vec3.t -> t
(** [of_vec3_exn v] is {!of_vec3}[ v].

    Raises [Invalid_argument] where that is [None]. *)

val of_vec3_or : t -> Vec3.t -> t
(** [of_vec3_or default v] is the direction of [v], or [default] if it has
    none. *)

val neg : t -> t
(** [neg d] is the opposite direction. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints like {!Vec3.pp}. *)
