(** Changes of place, size and form: what modifiers do to a shape or a light,
    one after the other. *)

(** The type for one of them, as it is written. *)
type modifier =
  | Scaled of float
      (** so many times as large, seen from the origin; greater than 0 *)
  | Stretched of Vec3.t
      (** each coordinate so many times as large; none of them 0. One that is
          negative mirrors. *)
  | Rotated of { axis : Direction.t; angle : float; sin : float; cos : float }
      (** turned around an axis through the origin, by an angle in degrees of
          this sine and cosine, as {!Affine.rotated} *)
  | Translated of Vec3.t  (** moved *)

type t
(** The type for changes. *)

val identity : t
(** [identity] leaves everything as it is. *)

val of_modifiers : modifier list -> t
(** [of_modifiers modifiers] is what they do, one after the other.

    Raises [Invalid_argument] if a number is not as it must be. *)

val compose : t -> t -> t
(** [compose second first] is [first], and then [second]. *)

val modifiers : t -> modifier list
(** [modifiers change] is all that it is made of, in the order in which they
    apply. *)

val similarity : t -> Similarity.t option
(** [similarity change] is [change] as one that keeps every shape what it is;
    [None] if it stretches. *)

val affine : t -> Affine.t
(** [affine change] is the modifiers of [change], composed from the last to the
    first: the same numbers for equal lists, however they were put together. *)

val share : t -> unit
(** [share change] works out its affine change now, for all that are composed
    of [change] to take it from there. *)

(** {1 What is written} *)

val name : modifier -> string
(** [name modifier] is the scene language's word for it, such as ["scaled"]. *)

val parameters : modifier -> (string * Parameter.t) list
(** [parameters modifier] is what is written after {!name}, in that order, each
    with its name. *)

val pp_with :
  (Format.formatter -> float -> unit) ->
  Format.formatter ->
  modifier list ->
  unit
(** [pp_with pp_number] prints modifiers as the scene language writes them,
    each after a blank, each number by [pp_number]. *)
