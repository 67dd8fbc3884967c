(** The path of the rays of a pixel, as lines to be drawn over the picture. *)

open Raylab_scene
open Raylab_tracer

(** The type for roles of rays. The ray from the eye has none: it is seen as a
    point, the pixel itself. *)
type role =
  | Mirrored
  | Not_followed  (** mirrored, where the chain had ended *)
  | Lit  (** a shadow ray that reaches its light *)
  | Blocked  (** a shadow ray that does not *)

val color : role -> int
(** [color role] is the colour of these rays, as [0xRRGGBB]. *)

val is_dashed : role -> bool
(** [is_dashed role] is whether they are drawn with gaps. *)

val name : role -> string
(** [name role] says in the legend what they are. *)

type t = {
  lines : (role * Segment.t) list;  (** in the order in which rays were cast *)
  hits : Segment.point list;  (** where rays of the chain hit *)
  blocks : Segment.point list;  (** where shadow rays end in an object *)
}
(** The type for overlays, in places of the picture, which may be outside it.
*)

val make : Camera.t -> first_row:int -> Explain.t -> t
(** [make camera ~first_row explanation] is the path of [explanation] as
    [camera] sees it, in the picture whose top row is [first_row] of all. Of
    more than 400 rays only the first are there. *)

val roles : t -> role list
(** [roles overlay] is the roles that occur, each once. *)
