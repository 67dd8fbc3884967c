(** A rendering that goes on while a viewer is served.

    It reads the scene, makes it ready and fills the picture, all of it on
    domains other than the one that calls this. *)

open Raylab_tracer

type t
(** The type for renderings under way. *)

(** What happened. *)
type news =
  | Failed of string  (** there is no scene, and why; it is over *)
  | Began of { scene : Prepared.t; picture : Picture.t; first_row : int }
      (** No pixel is set so far; the top row is [first_row] of all. *)
  | Tile of Pass.t * Tile.t  (** this part of the picture is there *)
  | Finished of float  (** after so many seconds; the picture is whole *)

val start :
  domains:int ->
  ?rows:Render.rows ->
  clock:(unit -> float) ->
  enter:(unit -> unit) ->
  (unit -> (Prepared.t, string) result) ->
  t
(** [start ~domains ~rows ~clock ~enter load] renders what [load ()] is, on
    [domains] domains, or one less if that is all that there are. If it has no
    such [rows] all of it is rendered. [clock ()] is the time in seconds.
    [enter ()] is called first, on the domain that then spawns the others. *)

val news : t -> news list
(** [news rendering] is what happened since the last question, in its order. *)

val stop : t -> unit
(** [stop rendering] asks it to end: no pixel is begun any more. *)

val is_over : t -> bool
(** [is_over rendering] is whether it has ended, for whichever reason. *)

val join : t -> unit
(** [join rendering] waits until it is over. Each rendering must be joined.

    Raises the exception that ended it, if one did. *)
