(** Whether a point is in a solid, kept up while it goes in and out of members.

    Each grouping is a gate that is up while at least so many of its parts
    count for it as it needs: one for a union, all for an intersection; for a
    difference one, where the first counts 1 and each other takes 1 away. So
    what goes up at a gate never makes it go down. *)

type t
(** The type for the gates of a solid. *)

type shape =
  | Member of int
  | Gate of { need : int; parts : (int * shape) list }
      (** The type for how they are connected: each part with its weight, 1 or
          -1. *)

val make : members:int -> shape -> t
(** [make ~members shape] is the gates of [shape], which is a [Gate], with so
    many members. *)

val count : t -> int
(** [count gates] is how many there are. *)

val flipped : t -> bool array
(** [flipped gates] is for each member whether going into it makes gates go
    down. *)

(** {1 Points}

    The counts of each gate are kept by the caller; all are 0 where the point
    is in no member. *)

val is_up : t -> int array -> bool
(** [is_up gates counts] is whether the point is in the solid. *)

val pass : t -> int array -> member:int -> enters:bool -> unit
(** [pass gates counts ~member ~enters] goes into [member], or out of it. *)

val standing :
  t -> before:int array -> after:int array -> moved:int array -> int
(** [standing gates ~before ~after ~moved] is the first member that made the
    solid's truth change from counts [before] to [after], where each member was
    gone into, if [moved] has 1 for it, or out of, if -1, or neither, if 0:
    from the whole on, it is in the first part that changed in the direction of
    the whole. *)
