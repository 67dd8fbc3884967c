(** What a rendering did, counted. *)

type t = {
  mutable primary : int;  (** rays from the eye *)
  mutable reflected : int;  (** mirrored rays *)
  mutable refracted : int;  (** rays that went through a surface *)
  mutable shadow : int;  (** rays towards lights *)
  mutable hits : int;  (** all of these but shadow rays that hit an object *)
  mutable blocked : int;  (** shadow rays that did not reach their light *)
  mutable samples : int;
      (** of all pixels; with several samples there are primary rays besides,
          from which it was seen that a pixel needs them *)
  mutable over_exposed : int;
      (** pixels of which a sample was brighter than a picture can show *)
}
(** The type for tallies. Each domain counts in one of its own. *)

val create : unit -> t
(** [create ()] is a tally of nothing. *)

val rays : t -> int
(** [rays tally] is the number of rays of all kinds. *)

val sum : t list -> t
(** [sum tallies] is a new tally of all that [tallies] counted. *)
