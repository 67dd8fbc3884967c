(** Names in expressions. *)

val map :
  binder:(string -> string) ->
  free:(string -> string) ->
  Expression.t ->
  Expression.t
(** [map ~binder ~free e] is [e] with each name that is bound outside of it
    replaced by what [free] makes of it, in the order in which they stand, and
    each point of a pattern in it called what [binder] makes of its name. Names
    are given as they are written. *)

val map_function :
  binder:(string -> string) ->
  free:(string -> string) ->
  Expression.parameter list ->
  Expression.t ->
  Expression.parameter list * Expression.t
(** [map_function ~binder ~free parameters body] is the same of a function. *)

val bound : Expression.parameter list -> Expression.t -> string list
(** [bound parameters e] is the names that [parameters] or something in [e]
    introduces, in lower case. *)

val without_places : Expression.t -> Expression.t
(** [without_places e] is [e] with all names in lower case, all places the
    same, and three numbers as the list of them, so that expressions which are
    printed alike are equal. *)
