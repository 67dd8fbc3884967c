(** Pictures of one scene after another, as far as they are rendered, and which
    of them is to be seen. *)

type t
(** The type for exhibits. *)

val start : t
(** [start] has no picture: the scene is being read. *)

val stage : t -> Stage.t
(** [stage exhibit] is how far the latest picture is. *)

val current : t -> Shown.t option
(** [current exhibit] is the latest that was begun. *)

val whole : t -> Shown.t option
(** [whole exhibit] is the latest that became whole. *)

(** {1 What happens} *)

val begin_ : at_once:bool -> Shown.t -> t -> t
(** [begin_ ~at_once shown exhibit] begins [shown]. It takes the place of what
    is seen bit by bit; [at_once], as soon as it is known everywhere, if
    coarsely: so a picture that follows a hand is never half another. *)

val note :
  Raylab_tracer.Pass.t ->
  Raylab_tracer.Tile.t ->
  t ->
  [ `Nothing | `Tile | `All ]
(** [note pass tile exhibit] notes that [pass] of [tile] of the latest picture
    is done, and is what of the exhibit looks otherwise than before. *)

val finish : float -> t -> t
(** [finish seconds exhibit] is that the latest picture has become whole. *)

val fail : string -> t -> t
(** [fail message exhibit] is that the scene is in error. *)

(** {1 What is to be seen} *)

val is_hidden : t -> bool
(** [is_hidden exhibit] is whether the latest picture is not to be seen yet. *)

val subject : t -> Shown.t option
(** [subject exhibit] is what a click is about. *)

val look : size:int * int -> t -> Raster.look option
(** [look ~size exhibit] is what is to be seen, of pictures of this size. *)
