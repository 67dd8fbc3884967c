(** Fans: what rays meet that all go through one point or along one direction.

    The eye's rays do, and the shadow rays to a lamp. A grid lies across such
    rays, and each of its cells knows which shapes can be seen through it, and
    in which order: a ray asks the few of its cell, where the hierarchy would
    have had to be gone through (after E. Haines and D. Greenberg, The Light
    Buffer, 1986). Shapes are tested as ever, so that answers stay what they
    are, bit for bit. *)

type source =
  | Eye of {
      eye : Vec3.t;
      right : Direction.t;
      above : Direction.t;
      forward : Direction.t;
      width : float;
      height : float;
    }
      (** rays from [eye] through a canvas at the distance 1 along [forward] *)
  | Point of Vec3.t  (** rays that end at a point *)
  | Along of Direction.t  (** rays that end far away, against this direction *)

type t
(** The type for fans. *)

val make : Leaves.t -> most:int -> source -> t option
(** [make leaves ~most source] is the fan of [leaves] from [source]; [None] if
    it would take more than [most] references, or numbers beyond 1e100. *)

(** {1 Questions}

    They are answered for rays of the fan that come from near enough. *)

val has_ray_from : t -> Raw_ray.t -> bool
(** [has_ray_from fan ray] is whether [fan] is of the eye and [ray] one of its
    rays. *)

val nearest : t -> Leaves.t -> Raw_ray.t -> Meeting.t -> unit
(** [nearest fan leaves ray meeting] lets the shapes that [ray], of which
    {!has_ray_from} holds, can meet offer where they are met. *)

val has_ray_to : t -> Raw_ray.t -> bool
(** [has_ray_to fan ray] is whether [fan] is of a light, and knows what lies on
    the way from the origin of [ray] to it. *)

val some : t -> Leaves.t -> Raw_ray.t -> Meeting.t -> unit
(** [some fan leaves ray meeting] lets the shapes that [ray], of which
    {!has_ray_to} holds and which goes to the light, can meet offer where they
    are met, until one is. *)
