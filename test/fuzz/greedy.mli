(** Programs that ask for too much: scenes, each with what it is. Each is in
    error, since what it asks for is more than a budget, or nested too deep. *)

val texts : (string * string) list
(** [texts] is one of each kind. *)

val slow : (string * string) list
(** [slow] is more of them, which take some seconds each until they are
    refused. *)
