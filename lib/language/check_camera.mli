(** What a header says of the camera: whether it is all, and fits together. *)

open Raylab_source

val tell : Findings.t -> seen:(string * Span.t) list -> stop:Span.t -> unit
(** [tell findings ~seen ~stop] tells at [stop] which settings are missing
    beside those that were [seen], and which contradict or lack each other. *)

val tell_view : Findings.t -> seen:(string * Span.t) list -> Settings.t -> unit
(** [tell_view findings ~seen settings] tells why no camera can look as
    [settings] say. Nothing may have been wrong with a single one. *)
