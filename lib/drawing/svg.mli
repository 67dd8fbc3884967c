(** Elements of SVG 1.1, as text. *)

type t = string
(** The type for elements and their contents, one after another. *)

type point = float * float

val document : width:float -> height:float -> title:string -> t list -> string
(** [document ~width ~height ~title elements] is a file of this size in pixels,
    white where there is nothing. [title] is what a reader of the screen says.
*)

val group : ?clip:string -> t list -> t
(** [group ~clip elements] is [elements], of which only what is inside the
    clipping path of this name is shown. *)

val clip_box : name:string -> point -> width:float -> height:float -> t
(** [clip_box ~name corner ~width ~height] is a clipping path. *)

val box : style:string -> point -> width:float -> height:float -> t
(** [box ~style corner ~width ~height] is a rectangle by its upper left corner.
    [style] is attributes, such as [{|fill="none"|}]. *)

val circle : style:string -> point -> float -> t
(** [circle ~style centre radius] is a circle. *)

val line : style:string -> point -> point -> t
(** [line ~style a b] is a line. *)

val polygon : style:string -> point list -> t
(** [polygon ~style corners] is a polygon. *)

val text :
  ?anchor:string -> ?size:float -> ?color:string -> point -> string -> t
(** [text p s] is the text [s], any string, starting at [p] or ending or
    centred there as [anchor] says ([start], [end] or [middle]), with a white
    rim that keeps it legible. U+FFFD stands for what XML cannot hold: control
    characters and bytes that are not UTF-8. *)
