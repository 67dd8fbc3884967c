(** A grid across the rays of a fan. Each of its cells lists the shapes that a
    ray through the cell may meet, the nearest to the source first; a cell with
    very many small ones has a finer grid of its own. *)

type t
(** The type for faces. *)

val make :
  Fan_view.frame -> Leaves.t -> window:Fan_view.t -> most:int -> t option
(** [make frame leaves ~window ~most] is the face of what is seen in [window].
    Its size is chosen so that a shape lies in about three cells; if even the
    coarsest takes more than [most] references, there is none. *)

val extent : Fan_view.frame -> Leaves.t -> float
(** [extent frame leaves] is the largest of all coordinates, that of the source
    included. *)

val length : t -> int
(** [length face] is how many references it has. *)

(** {1 Questions} *)

val meet :
  any:bool ->
  t ->
  Leaves.t ->
  u:float ->
  v:float ->
  pace:float ->
  depth:float ->
  Raw_ray.t ->
  Meeting.t ->
  unit
(** [meet ~any face leaves ~u ~v ~pace ~depth ray meeting] lets all shapes that
    can be met by [ray], which goes through (u, v) of the face, offer where
    they are met: those that begin before [depth], and before what is met, as
    far as it is known: at distance t the ray is at the depth [pace *. t]. With
    [any] it stops at the first meeting. *)
