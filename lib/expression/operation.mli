(** What operators and built-in functions make of values.

    What has no value raises {!Fault.Found} at the expression. *)

val number : 'thing Value.run -> Expression.t -> 'thing Value.t -> float
(** [number run e value] is [value], that of [e], where a number must stand. *)

val truth : 'thing Value.run -> Expression.t -> 'thing Value.t -> bool
(** [truth run e value] is the same for a truth value. *)

val vector :
  'thing Value.run -> Expression.t -> 'thing Value.t -> Raylab_geometry.Vec3.t
(** [vector run e value] is the same for a vector. *)

val elements :
  'thing Value.run -> Expression.t -> 'thing Value.t -> 'thing Value.t array
(** [elements run e value] is the same for a list. *)

val wanted : 'thing Value.run -> Expression.t -> string -> 'thing Value.t -> 'a
(** [wanted run e what value] raises {!Fault.Found}: [what] must stand there,
    such as ["a number"], and not [value]. *)

val negative :
  'thing Value.run -> Expression.t -> 'thing Value.t -> 'thing Value.t
(** [negative run e v] is [-v]; [e] is the operand. *)

val binary :
  'thing Value.run ->
  Expression.t ->
  Expression.operator ->
  'thing Value.t ->
  'thing Value.t ->
  'thing Value.t
(** [binary run e operator a b] is what [operator], not [And] or [Or], makes of
    [a] and [b]; [e] is the whole. *)

val builtin :
  'thing Value.run ->
  Raylab_source.Span.t ->
  Builtin.t ->
  'thing Value.t array ->
  'thing Value.t
(** [builtin run span f arguments] is what [f] makes of as many [arguments] as
    it has parameters; [span] is the call. *)
