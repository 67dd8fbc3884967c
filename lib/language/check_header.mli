(** The header of a scene: which settings it must have, and their limits. *)

open Raylab_scene

val check : Findings.t -> Syntax.t -> unit
(** [check findings syntax] adds what is wrong with the header. *)

(** {1 What a header says}

    These are for a header in which {!check} has found nothing. *)

val camera : Syntax.t -> Camera.t
(** [camera syntax] is the camera that it describes. *)

val background : Syntax.t -> Color.t option
(** [background syntax] is the background, if it is set. *)

val ray_depth : Syntax.t -> int option
(** [ray_depth syntax] is how many rays a chain may have, if it is set. *)
