(** Dashed lines, which Graphics does not know. *)

open Raylab_drawing

val cut :
  float * float ->
  Drawing.point * Drawing.point ->
  (Drawing.point * Drawing.point) list
(** [cut (dash, gap) (a, b)] is the line from [a] to [b] cut into dashes [dash]
    pixels long and [gap] apart; the last may be shorter. *)
