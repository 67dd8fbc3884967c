(** Frames: the values of the names of a call that goes on. *)

type 'thing t = {
  mutable slots : 'thing Value.t array;
  outer : 'thing t;  (** of the function around; of the outermost itself *)
  run : 'thing Value.run;
}
(** The type for frames. *)

val start : 'thing Value.run -> size:int -> 'thing t
(** [start run ~size] is the outermost frame. *)

val need : 'thing t -> int -> unit
(** [need frame size] gives [frame] at least [size] slots. *)

val set : Scope.binding -> 'thing t -> 'thing Value.t -> unit
(** [set binding frame value] gives the name its value, in the frame of the
    function in which it is bound. *)

val read : Scope.binding -> levels:int -> 'thing t -> 'thing Value.t
(** [read binding ~levels] reads the value of the name, in the frame [levels]
    functions further out. It raises {!Fault.Known} if there is none. *)
