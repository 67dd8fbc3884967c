(** What goes wrong in an evaluation. *)

open Raylab_source

type t = {
  span : Span.t;  (** the expression in question *)
  message : string;  (** what is wrong with it *)
  advice : string;  (** what to do, or [""] *)
  ends : bool;  (** whether nothing more can be evaluated *)
}
(** The type for faults. *)

exception Found of t
(** Ends the evaluation of an item of a scene, or of a pattern. *)

exception Known
(** Ends it where a fault that has been told already is the reason: a name is
    used whose definition failed. *)

val fail : Span.t -> ?advice:string -> string -> 'a
(** [fail span message] raises {!Found}: [span] is wrong. *)

val stop : Span.t -> ?advice:string -> string -> 'a
(** [stop span message] raises {!Found}: the budget is used up at [span]. *)
