(** What a shape looks like from where the rays of a fan come: a conservative
    rectangle, depth and disc.

    A fan's rays go through one point, the source, or all along one direction.
    Their places are numbers u and v across them: for a source, of the plane at
    depth 1 before it, as if that were a canvas. *)

type frame = private {
  axes : float array;
      (** three vectors of length 1, each on another at right angles: along u,
          along v, and into the depth *)
  origin : float array;  (** the source; the origin for parallel rays *)
  parallel : bool;
}
(** The type for where the rays of a fan come from and go. *)

val frame : ?source:Vec3.t -> Vec3.t -> Vec3.t -> Vec3.t -> frame
(** [frame ~source u v depth] is that of rays through [source], or along
    [depth] if there is none. *)

type t = {
  mutable least_u : float;
  mutable most_u : float;
  mutable least_v : float;
  mutable most_v : float;
  mutable depth : float;  (** no point of the shape is nearer *)
  mutable u : float;  (** the middle of a disc that holds all of it, *)
  mutable v : float;
  mutable radius : float;  (** and its radius; infinite if there is none *)
}
(** The type for registers of what is seen. *)

val create : unit -> t
(** [create ()] is a new register. *)

val see : frame -> Leaves.t -> int -> margin:float -> window:t -> t -> bool
(** [see frame leaves place ~margin ~window view] puts into [view] what the
    shape at [place] looks like, if that were larger by [margin] and ended at
    the sides of [window]. Its result is whether anything of it is in the
    window and before the source; if not, [view] has no meaning. *)

val everything : unit -> t
(** [everything ()] is a window without end. *)
