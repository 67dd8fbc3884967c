(** What is drawn in the window. *)

val background : int
(** [background] is the colour of what shows nothing. *)

val nothing : Canvas.t -> Box.t -> unit
(** [nothing canvas box] draws the part [box] of a window without a picture. *)

val picture : Canvas.t -> Raster.t -> Raster.look -> Box.t -> unit
(** [picture canvas raster look box] draws the rows of the part [box] of the
    window, where the picture has this [look]. *)

val path : Canvas.t -> Layout.t -> pixel:int * int -> Path_overlay.t -> unit
(** [path canvas layout ~pixel overlay] draws the path of [pixel] over the
    picture, and a legend if there is room. *)

val message : Canvas.t -> Layout.t -> string -> unit
(** [message canvas layout text] writes as much of [text] as there is room for.
*)
