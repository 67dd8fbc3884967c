(** Shapes that a change has made another kind of shape: a ball that is
    stretched, a box that is turned.

    A ray is met in the shape's own coordinates: what brings the shape to its
    place, undone, brings the ray to the shape. There its direction has another
    length; it is made 1 again, and distances are divided by that length. *)

type 'shape t = private {
  own : 'shape;  (** as it was written, in its own coordinates *)
  modifiers : Change.modifier list;  (** what brings it to its place *)
  out : Affine.t;  (** the same *)
  back : Affine.t;  (** its inverse *)
}
(** The type for changed shapes. *)

val make : Change.t -> 'shape -> 'shape t
(** [make change own] is [own] where [change] puts it.

    Raises [Invalid_argument] if a number of it or of its inverse is not
    finite. *)

val change : Change.t -> 'shape t -> 'shape t
(** [change second placed] is [placed], and then [second].

    Raises [Invalid_argument] likewise. *)

val with_own : 'own -> 'shape t -> 'own t
(** [with_own own placed] is [own] where [placed] is. *)

(** {1 What is hit}

    Each function gets that of the own shape. The ray is as it was afterwards,
    but for its reach. *)

val offer :
  ('shape -> Raw_ray.t -> Meeting.t -> number:int -> unit) ->
  'shape t ->
  Raw_ray.t ->
  Meeting.t ->
  number:int ->
  unit
(** [offer own placed] is {!Shape.offer}. *)

val settle :
  ('shape -> part:int -> Raw_ray.t -> Spot.t -> unit) ->
  'shape t ->
  part:int ->
  Raw_ray.t ->
  Spot.t ->
  unit
(** [settle own placed] is {!Shape.settle}. *)

val crossings :
  ('shape -> Raw_ray.t -> Crossings.t -> unit) ->
  'shape t ->
  Raw_ray.t ->
  Crossings.t ->
  unit
(** [crossings own placed] is {!Shape.crossings_raw}. *)

(** {1 Where it is} *)

val box : Box3.t -> 'shape t -> Box3.t
(** [box own placed] is a box around [placed], where [own] is one around its
    own shape. *)

val depth : ('shape -> Vec3.t -> float) -> 'shape t -> Vec3.t -> float
(** [depth own placed] is {!Shape.depth}; where the change stretches, points
    may lie deeper, and farther outside, than it says. *)

val plane : Plane.t t -> Plane.t
(** [plane placed] is the plane that [placed] is: any change leaves it one. *)
