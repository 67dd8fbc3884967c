(** Colours as one channel, their brightness.

    The tracer works in {!Color}. It needs no second version for greyscale:
    {!to_color} takes [add], [scale] and [multiply] here to the same there, so
    a scene whose colours are greys ({!Scene.greyscale}) is traced in each of
    the three channels exactly as it would be in one. *)

include Color_intf.S with type t = float
(** [pp] prints [grey 0.5]. *)

val of_color : Color.t -> t
(** [of_color c] is the {!Color.luminance} of [c]. *)

val to_color : t -> Color.t
(** [to_color g] is the colour with [g] in each channel. *)
