(** Files that are included, made ready to be evaluated. *)

open Raylab_source
open Raylab_expression

type item =
  Check.t ->
  Scope.t ->
  at:Span.t ->
  Syntax.item ->
  Scope.t * (Check.frame -> Sink.t -> unit)
(** The type for what makes an item ready; see {!Evaluate_item.compile}. *)

val compile : item -> Check.t -> Syntax.inclusion -> File_code.t
(** [compile item check inclusion] is the file that is included, which knows
    what is built in and its own includes. Its code is the same however often
    it is included, and its definitions are evaluated once. *)

val names : Scope.t -> File_code.t -> Scope.t
(** [names scope file] is [scope] with all that [file] defines. *)
