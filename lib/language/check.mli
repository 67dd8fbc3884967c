(** Evaluation that goes on after errors.

    What is wrong with a parameter is told, and the evaluation of the next ones
    goes on: one run finds every error. *)

open Raylab_expression

type t
(** The type for what is known of the item that is being evaluated. *)

val start : Findings.t -> Scope.t -> Thing.t Frame.t -> t
(** [start findings scope frame] tells [findings]. What is built in is known in
    [scope], which is that of the outermost [frame]. *)

val findings : t -> Findings.t
(** [findings check] is where errors are told. *)

type frame = Thing.t Frame.t

val outermost : t -> Scope.t * frame
(** [outermost check] is the scope and frame in which files start. *)

val file : t -> int -> (unit -> File_code.t) -> File_code.t
(** [file check base compile] is [compile ()], once for the file that starts at
    [base]. *)

val failed : t -> bool
(** [failed check] is whether anything in the innermost {!whole} is wrong. *)

val attempt : t -> frame -> 'a -> (unit -> 'a) -> 'a
(** [attempt check frame default f] is [f ()], or [default] after telling what
    went wrong. What ends all evaluation is raised again. *)

type 'a ready = frame -> 'a
(** The type for what is made ready to be evaluated. *)

(** What follows is nested as deep as calls are, and JavaScript's stack is
    small: so each is one function, of all that it takes at once. *)

val whole : t -> 'a ready -> 'a ready
(** [whole check build frame] is [build frame]. If anything in it was told to
    be wrong, it raises {!Raylab_expression.Fault.Known}. *)

val item : t -> (frame -> 'sink -> unit) -> frame -> 'sink -> unit
(** [item check code frame sink] is {!attempt} of {!whole} of
    [code frame sink]. *)
