(** Solids: shapes put together by what is inside of them. *)

type operation = Union | Intersection | Difference

(** The type for how they are put together. A difference is its first part
    without all others. *)
type 'member tree =
  | Member of 'member
  | Combined of operation * 'member tree list

type 'shape t = private {
  tree : int tree;  (** its members, by number *)
  members : 'shape array;  (** in the order in which they stand *)
  flipped : bool array;
      (** whether a member is taken away, so that its outside is inside *)
  gates : Gates.t;
  tolerance : float;
      (** faces of two members that are nearer together along a ray coincide *)
}
(** The type for solids. *)

val make : 'shape tree -> 'shape t
(** [make tree] is what [tree] says, with no tolerance but for rounding.

    Raises [Invalid_argument] if an intersection or a difference has no part.
*)

val map : ('shape -> 'shape) -> 'shape t -> 'shape t
(** [map f solid] is [solid] with [f] of each member for it. *)

val map_tree : ('a -> 'b) -> 'a tree -> 'b tree
(** [map_tree f tree] is [tree] with [f] of each member for it. *)

val with_members : 'shape array -> 'shape t -> 'shape t
(** [with_members members solid] is [solid] with as many other members. *)

val with_tolerance : float -> 'shape t -> 'shape t
(** [with_tolerance e solid] is [solid] whose faces coincide within [e]. *)

val to_tree : 'shape t -> 'shape tree
(** [to_tree solid] is what it is made of. *)

val word : operation -> string
(** [word operation] is the scene language's word, such as ["union"]. *)

val operation : 'shape t -> operation
(** [operation solid] is that of the whole. *)

(** {1 Parts}

    A part of a solid is a part of one of its members. *)

val member_of : 'shape t -> part:int -> int
(** [member_of solid ~part] is the number of the member, from 0. *)

val own_part : 'shape t -> part:int -> int
(** [own_part solid ~part] is the part of that member. *)

(** {1 What is hit}

    The crossings of all members lead in and out of them. Taken in order along
    the line, with those that coincide at once, they lead in and out of the
    solid where its truth changes. Of the faces that coincide there, the first
    one that does stands for all. *)

val offer :
  ('shape -> Raw_ray.t -> Crossings.t -> unit) ->
  'shape t ->
  Raw_ray.t ->
  Meeting.t ->
  number:int ->
  unit
(** [offer crossings solid] is {!Shape.offer}, with the [crossings] of members.
*)

val settle :
  ('shape -> part:int -> Raw_ray.t -> Spot.t -> unit) ->
  'shape t ->
  part:int ->
  Raw_ray.t ->
  Spot.t ->
  unit
(** [settle member solid] is {!Shape.settle}; the normal of what is taken away
    is turned around. *)

val crossings :
  ('shape -> Raw_ray.t -> Crossings.t -> unit) ->
  'shape t ->
  Raw_ray.t ->
  Crossings.t ->
  unit
(** [crossings members solid] is {!Shape.crossings_raw}. *)

(** {1 Where it is} *)

val box : ('shape -> Box3.t option) -> 'shape t -> Box3.t option
(** [box member solid] is a box around [solid]: of an intersection where those
    of its parts meet, of a difference that of its first. *)

val numbers : 'shape t -> float array
(** [numbers solid] is how it is put together, as numbers. *)

val pp_with :
  (Format.formatter -> 'shape -> unit) -> Format.formatter -> 'shape t -> unit
(** [pp_with member] prints [difference sphere ..., plane ... end]. *)

val depth : ('shape -> Vec3.t -> float) -> 'shape t -> Vec3.t -> float
(** [depth member solid point] is {!Shape.depth}, or less far from 0. *)
