(** Objects of glass. *)

val least_ray_depth : int
(** [least_ray_depth] is 8: with shorter chains, much of what glass shows is
    the background. *)

val warnings : ray_depth:int -> Object.t list -> Warning.t list
(** [warnings ~ray_depth objects] tells of glass on what does not close, which
    light goes into and never leaves, and of a ray depth below
    {!least_ray_depth} where there is glass. *)

val lets_through : Object.t -> bool
(** [lets_through o] is whether some of the light that meets [o] may go on
    through it. *)
