(** What is drawn in the window. *)

val background : int
(** [background] is the colour of what shows nothing. *)

val picture : Canvas.t -> Layout.t -> (x:int -> y:int -> int) -> Box.t -> unit
(** [picture canvas layout color box] draws the part [box] of the window, where
    pixels of the picture have their [color]. *)

val path : Canvas.t -> Layout.t -> pixel:int * int -> Path_overlay.t -> unit
(** [path canvas layout ~pixel overlay] draws the path of [pixel] over the
    picture, and a legend if there is room. *)

val message : Canvas.t -> Layout.t -> string -> unit
(** [message canvas layout text] writes as much of [text] as there is room for.
*)
