(** Hits: from a ray and the object that it hits to the register of the hit. A
    part of {!Evaluator}. *)

val find : Registers.t -> int -> unit
(** [find t number] puts the hit of the ray, at the end of its reach, on object
    [number], from 0, into its register. *)

val tell : Registers.t -> int -> unit
(** [tell t number] tells the observer, if there is one, of that hit. *)

val hit : Registers.t -> int -> Hit.t
(** [hit t number] is that hit. *)

(** {1 Where doubles end} *)

val farthest : float
(** [farthest] is 2^1022: no hit lies farther out, so that what is computed
    from it is finite. *)

val within : float -> float
(** [within x] is the coordinate [x], not beyond {!farthest}. *)
