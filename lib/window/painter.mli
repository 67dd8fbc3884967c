(** What is painted in the window. *)

open Raylab_drawing
open Raylab_viewer

val drawing : Canvas.t -> Drawing.t -> unit
(** [drawing canvas d] paints [d], whose places are those of the window, near
    it if not in it. Words are in the one font that there is, in ASCII; areas
    that are not opaque have but an outline. *)

val viewer : Canvas.t -> Viewer.t -> Viewer.t
(** [viewer canvas v] shows what has changed to be seen in [v], and is [v] once
    it was drawn. *)
