(** Settings of the header, evaluated and checked. *)

open Raylab_source
open Raylab_expression

type t
(** The type for headers as far as they are read. *)

val start : Check.t -> t
(** [start check] has no setting. *)

val set : t -> Scope.t -> Syntax.setting -> Check.frame -> unit
(** [set header scope setting frame] evaluates [setting], which must not have
    been set before. *)

val finish : t -> Span.t -> unit
(** [finish header stop] tells at [stop] which settings are missing, and which
    contradict each other. *)

val settings : t -> Settings.t
(** [settings header] is what they say, as far as nothing was wrong. *)
