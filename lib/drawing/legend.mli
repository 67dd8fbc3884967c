(** What the lines of rays mean. *)

val in_line : Drawing.point -> Drawing.t
(** [in_line p] explains the kinds of rays on paper, beside each other, from
    [p]. *)

val width : float
(** [width] is how wide that is. *)
