(** What is painted in the window. *)

open Raylab_drawing

val background : int
(** [background] is the colour of what shows nothing. *)

val nothing : Canvas.t -> Box.t -> unit
(** [nothing canvas box] paints the part [box] of a window without a picture.
*)

val picture : Canvas.t -> Raster.t -> Raster.look -> Box.t -> unit
(** [picture canvas raster look box] paints the rows of the part [box] of the
    window, where the picture has this [look]. *)

val drawing : Canvas.t -> Drawing.t -> unit
(** [drawing canvas d] paints [d], whose places are those of the window, near
    it if not in it. Words are in the one font that there is, in ASCII; areas
    that are not opaque have but an outline. *)

val message : Canvas.t -> Layout.t -> string -> unit
(** [message canvas layout text] writes as much of [text] as there is room for.
*)
