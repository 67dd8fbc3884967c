(** What the lines of rays mean. *)

(** {1 On paper} *)

val in_line : Path.t -> Drawing.point -> Drawing.t
(** [in_line path p] explains the kinds of rays on paper, beside each other,
    from [p]; refracted ones if [path] has some. *)

val width : Path.t -> float
(** [width path] is how wide that is. *)

(** {1 Over a picture} *)

val in_corner :
  text_size:(string -> float * float) ->
  Rectangle.t ->
  Path.kind list ->
  Drawing.t
(** [in_corner ~text_size window kinds] explains [kinds], below each other, in
    the lower left corner of [window], where a line of words has the width and
    the height [text_size words]. It is nothing where there is no room. *)
