(** Files that are included, made ready to be evaluated. *)

open Raylab_expression

type t = {
  names : (string * Scope.binding) list;
      (** what it defines, in the outermost frame *)
  define : unit -> unit;  (** gives them their values, the first time *)
  settings : (Scope.t * Syntax.setting) list;
      (** of its header, each with what is known there *)
  place : Sink.t -> unit;  (** puts its lights and objects into a sink *)
}
(** The type for files that are ready. *)
