(** Room to work in for shapes that are put together.

    Whoever asks a {!Solid} what a ray meets brings it along in the meeting, so
    that nothing is allocated once it has grown large enough, and no two
    domains share one. What it holds between two questions is of no meaning. *)

type t = {
  own : Crossings.t;  (** those of one member *)
  all : Crossings.t;  (** those of all members, one member after the other *)
  mutable members : int array;  (** whose each of them is *)
  mutable enters : bool array;  (** whether it leads into that member *)
  mutable order : int array;  (** the crossings in ascending order *)
  mutable at : int;  (** how many of them, in order, have been passed *)
  mutable counts : int array;  (** for each gate how far it is up *)
  mutable before : int array;  (** the same before some crossings *)
  mutable moved : int array;
      (** for each member 1 if these lead into it, -1 if out of it, else 0 *)
}
(** The type for rooms. *)

val create : unit -> t
(** [create ()] is a new, small room. *)

val reset : t -> gates:int -> members:int -> unit
(** [reset room ~gates ~members] forgets all crossings; the counts of so many
    gates, and there is room for the moves of so many members. *)

val add_own : t -> member:int -> members:int -> unit
(** [add_own room ~member ~members] adds the crossings of [own] to [all], as
    those of [member], one of [members]: a part of it becomes
    [part * members + member]. *)

val sort : t -> unit
(** [sort room] makes [order] the order of all crossings; those at the same
    distance stay in the order in which they were added. *)
