(** Where names stand for what, before anything is evaluated.

    Names are resolved once: the value of each has a slot in the frame of the
    function around it. Case does not matter. *)

open Raylab_source

type binding = {
  level : int;  (** of the function around it *)
  slot : int;
  span : Span.t;  (** where the name is introduced *)
  mutable is_defined : bool;  (** false inside of its own definition *)
}
(** The type for what a name is bound to. *)

type t
(** The type for scopes: the names that are known at a place. *)

type report = Span.t -> advice:string -> string -> unit
(** The type for what tells an error that is found before the evaluation. *)

val start : ?hint:(string -> string option) -> report -> t
(** [start ~hint report] knows no name. [hint name] is what is said of an
    unknown [name] that means something elsewhere, by default nothing. *)

val bind : t -> ?is_defined:bool -> string -> Span.t -> t * binding
(** [bind scope name span] knows [name] as well, in a new slot. *)

val add : t -> string -> binding -> t
(** [add scope name binding] knows [name] as well, which another scope of the
    same frame has bound. *)

val enter : t -> t
(** [enter scope] is [scope] as it is inside of a function. *)

val level : t -> int
(** [level scope] is the number of functions around, and [size scope] below how
    many slots the innermost of them needs. *)

val size : t -> int
(** [size scope] is the number of slots so far in the frame of the innermost
    function. *)

val find : t -> string -> binding option
(** [find scope name] is what [name] is bound to. *)

val names : t -> string list
(** [names scope] is all that are known, in lower case. *)

val report : t -> report
(** [report scope] tells an error. *)

val hint : t -> string -> string option
(** [hint scope name] is what there is to be said of an unknown [name]. *)

val report_once : t -> string -> Span.t -> advice:string -> string -> unit
(** [report_once scope name span ~advice message] tells an error about [name],
    the first time that there is one. *)
