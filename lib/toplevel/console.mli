(** What the prompt prints besides values: in the words of the command line. *)

open Raylab_scene
open Raylab_language
open Raylab_tracer
open Raylab_explanation

(** {1 Scene files} *)

val errors : Scene_error.t list -> unit
(** [errors list] prints [list] on standard error. *)

val warnings : ?path:string -> string list -> unit
(** [warnings ~path texts] prints these warnings on standard error, each after
    the [path] of the scene that they are about, if it was read. *)

val contents : string -> Scene.t -> unit
(** [contents path scene] prints how much is in [scene], on one line. *)

(** {1 Explanations} *)

val swatches : unit -> Swatch.t
(** [swatches ()] is the patches of colour that standard output can show. *)

val summary : Explain.pixel -> unit
(** [summary pixel] prints the summary of an explanation. *)
