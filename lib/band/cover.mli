(** Rows 0 to [height - 1], covered by bands in any order. *)

type 'a piece = { part : 'a; first : int; last : int }
(** Rows [first] to [last], both included, of [part]. *)

val pieces : height:int -> 'a piece list -> 'a piece list * (int * int) list
(** [pieces ~height bands] is [(pieces, missing)]: from the topmost on, pieces
    of [bands] that follow each other without overlap, and the first and last
    row of every gap between them. Together they have each row once. *)

val within : first:int -> last:int -> 'a piece list -> 'a piece list
(** [within ~first ~last pieces] is what of [pieces] lies in these rows. *)
