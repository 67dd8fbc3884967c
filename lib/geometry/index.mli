(** Sets of shapes that can be asked what a ray hits. *)

type t
(** The type for sets of shapes, and how they are searched; no answer depends
    on that. *)

val brute_force : Shape.t array -> t
(** [brute_force shapes] tests every shape for every ray: slow, and so plain
    that all others are measured by it. *)

val hierarchy : ?domains:int -> Shape.t array -> t
(** [hierarchy shapes] is searched by a {!Bvh}, which is built on at most
    [domains] domains, by default 1. *)

val for_many_rays :
  ?domains:int -> ?eye:Fan.source -> lights:Fan.source option array -> t -> t
(** [for_many_rays ~eye ~lights index] is [index] made ready for a whole
    picture: with {!Fan}s for rays from the eye, and for those of the series k,
    counted from 1, that go to the light at the place k - 1 of [lights], where
    that has a source; and with a {!Grid} for all others, if by its cost that
    is a shorter way than the hierarchy. Making them takes about 2 us a shape.

    Where they would take too much memory, there are none, nor fans where an
    [int] has too few bits; and an index of {!brute_force} has none. They are
    made on at most [domains] domains, by default 1. *)

val ask : t -> Finder.t
(** [ask index] is a new way to ask. *)
