(** The two questions that a tracer asks of a set of shapes.

    Shapes are numbered by their place in the array that the query was made
    from. A hit counts if its distance [t] satisfies [0 < t < reach] of the ray.
    Answers depend on nothing but the arguments, and any number of domains may
    ask at once. *)

type t = {
  nearest : Ray.t -> int;
      (** [nearest ray] is the number of the shape that [ray] hits first, or
          {!no_shape}. Of shapes hit at the same distance it is the one with the
          lowest number. *)
  blocked : Ray.t -> bool;  (** [blocked ray] is whether [ray] hits any shape. *)
}
(** The type for answers to both questions over some set of shapes. *)

val no_shape : int
(** [no_shape] is the number, -1, that stands for no shape. *)

val brute_force : Shape.t array -> t
(** [brute_force shapes] tests every shape for every ray: slow, and so plain
    that every other query is measured by it. *)
