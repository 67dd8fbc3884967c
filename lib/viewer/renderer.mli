(** Renderings, one at a time. *)

type t
(** The type for renderers. *)

val make : (unit -> Rendering.t) -> t
(** [make start] renders nothing yet. [start ()] starts a rendering. *)

val restart : t -> unit
(** [restart renderer] makes it render anew; what is under way is stopped. *)

val news : t -> Rendering.news list
(** [news renderer] is what happened since the last question, in its order.
    What there is to start is started by this question.

    Raises the exception that ended a rendering, if one did. *)

val is_busy : t -> bool
(** [is_busy renderer] is whether a rendering is under way or to be started. *)

val finish : t -> unit
(** [finish renderer] stops what is under way and waits for its end. *)
