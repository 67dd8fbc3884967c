(** How much of an area light a point sees. *)

open Raylab_scene
open Raylab_tracer

type blocker = { by : int; name : string }
(** The type for what is in the way: its number and what it is called. *)

type t = {
  seen : int;
  points : int;  (** all of the light *)
  hidden : (blocker * int) list;
      (** what hides how many of them, by its number *)
  behind : int;  (** of them, behind the surface *)
}
(** The type for how many points of an area light are seen, and why not all. *)

val blocker : int -> Object.t -> Provenance.t option -> blocker
(** [blocker k o place] is the object [o] of number [k] at [place]. *)

val make : Explain.verdict list -> t
(** [make points] counts the verdicts of all points of a light. *)

val others : exact:bool -> t -> string
(** [others ~exact t] says why not all points are seen, of which some are:
    [sphere 3 (line 24) hides the others]; no numbers unless [exact]. *)

val to_string : t -> string
(** [to_string t] is
    [11 of 16 points are seen, while sphere 3 (line 24) hides the others]. *)
