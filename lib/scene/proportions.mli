(** Whether a picture has the proportions of its canvas. *)

val distortion : Camera.t -> string option
(** [distortion camera] is how the picture looks if its proportions are not
    those of the canvas: ["2 times as wide as it should"]. It is [None] up to a
    hundredth, and where whole numbers of pixels come no nearer. *)

val warnings : Camera.t -> Warning.t list
(** [warnings camera] is what is said of a {!distortion}. *)

val fitting_height : Camera.t -> int
(** [fitting_height camera] is the height in pixels that goes with the width of
    the picture and the proportions of the canvas. *)
