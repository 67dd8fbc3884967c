(** The two questions that a tracer asks of a set of shapes.

    Shapes are numbered by their place in the array that they came in. A hit
    counts if its distance [t] satisfies [0 < t < reach] of the ray. *)

type t = {
  nearest : Raw_ray.t -> Meeting.t -> unit;
      (** [nearest ray meeting] makes [meeting] what [ray] hits first, or no
          meeting. Of shapes hit at the same distance it is the one with the
          lowest number. The distance of the hit becomes the ray's reach. *)
  blocked : int -> Raw_ray.t -> bool;
      (** [blocked series ray] is whether [ray] hits any shape. The ray's reach
          may be another afterwards. It changes nothing in the answer which
          [series], a number of one's choice, a ray belongs to; it is quickest
          if the rays of one series, such as those to one light, lie close
          together. *)
}
(** The type for ways to ask. One of these may keep notes for itself, on which
    no answer depends; so each domain needs one of its own. *)
