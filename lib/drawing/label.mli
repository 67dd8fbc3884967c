(** Labels in a panel, and room for them. *)

type t
(** The type for labels. *)

val make :
  ?anchor:Drawing.anchor ->
  ?size:float ->
  ?ink:int ->
  ?reach:float ->
  Drawing.point list ->
  string ->
  t
(** [make places words] is the label [words] at the first of [places] where
    there is room, or else at most [reach] pixels, by default 60, from the
    first. The rest is as in {!Drawing.val-text}. *)

val box : t -> Drawing.point -> Rectangle.t
(** [box label p] is what [label] covers if it stands at [p], whatever the
    font. *)

val arrange : Rectangle.t -> busy:Rectangle.t list -> t list -> Drawing.t
(** [arrange panel ~busy labels] is those of [labels] for which there is room,
    the first before the others: inside [panel], where they cover no other
    label and, if there is a choice, none of [busy]. *)
