(** The shapes of a scene that have a box, in an order in which neighbours in
    space are neighbours in memory. *)

type t = private {
  numbers : int array;  (** of the shape at each place *)
  balls : float array;
      (** x, y, z and radius of the sphere at each place; four zeros for a
          shape of another kind *)
  boxes : float array;
      (** the least and the greatest x of the shape at each place, and so on
          for y and z; nothing if all are spheres *)
  shapes : Shape.t array;  (** all, by number *)
  extent : float;  (** the largest of all their coordinates *)
}
(** The type for leaves. *)

val make : Shape.t array -> numbers:int array -> balls:float array -> t
(** [make shapes ~numbers ~balls] is the shapes of [numbers], each of which has
    a {!Shape.box}, in that order. [balls] has the rows of spheres. *)

val count : t -> int
(** [count leaves] is how many there are. *)

val is_ball : t -> int -> bool
(** [is_ball leaves place] is whether a sphere is at [place]. *)

val offer : t -> int -> Raw_ray.t -> Meeting.t -> unit
(** [offer leaves place ray meeting] lets the shape at [place] offer where it
    meets [ray]. *)
