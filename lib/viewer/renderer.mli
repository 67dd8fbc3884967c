(** Renderings, one at a time. *)

type t
(** The type for renderers. *)

val make : unit -> t
(** [make ()] renders nothing yet. *)

val restart : t -> (unit -> Rendering.t) -> unit
(** [restart renderer start] makes it render what [start ()] starts; what is
    under way is stopped. *)

val news : t -> Rendering.news list
(** [news renderer] is what happened since the last question, in its order.
    What there is to start is started by this question.

    Raises the exception that ended a rendering, if one did. *)

val is_busy : t -> bool
(** [is_busy renderer] is whether a rendering is under way or to be started. *)

val is_turning : t -> bool
(** [is_turning renderer] is whether one is being stopped for another. *)

val finish : t -> unit
(** [finish renderer] stops what is under way and waits for its end. *)
