(** Labels in a picture of a path, and room for them. *)

type t
(** The type for labels. *)

val make :
  ?anchor:string ->
  ?size:float ->
  ?color:string ->
  ?reach:float ->
  View.point list ->
  string ->
  t
(** [make places words] is the label [words] at the first of [places] where
    there is room, or else at most [reach] pixels, by default 60, from the
    first. The rest is as in {!Svg.text}. *)

val box : t -> View.point -> Rectangle.t
(** [box label p] is what [label] covers if it stands at [p], whatever the
    font. *)

val arrange : View.t -> marks:Rectangle.t list -> t list -> Svg.t list
(** [arrange view ~marks labels] is those of [labels] for which there is room,
    the first before the others: inside the panel, where they cover no other
    label and, if there is a choice, none of [marks]. *)
