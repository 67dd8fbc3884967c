(** Names, made ready to be evaluated. *)

open Raylab_source

val compile :
  Scope.t -> string -> Span.t -> calls:bool -> 'thing Frame.t -> 'thing Value.t
(** [compile scope name span ~calls] reads the value of [name]: what [scope]
    binds it to, a built-in function, or a built-in constant. One that nobody
    knows is told, once, as a function if it is called. *)
