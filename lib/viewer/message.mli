(** Messages: lines written into a window. *)

open Raylab_drawing

val draw :
  text_size:(string -> float * float) -> Rectangle.t -> string -> Drawing.t
(** [draw ~text_size window text] is as much of [text] as there is room for in
    [window], where a line of words has the width and the height
    [text_size words], and letters are equally wide. *)

val note :
  text_size:(string -> float * float) ->
  ?avoid:Rectangle.t ->
  Rectangle.t ->
  string ->
  Rectangle.t * Drawing.t
(** [note ~text_size ~avoid window text] is as much of [text] as there is room
    for in half of [window], on paper of its own, before which it can be read
    over any picture; and the part of [window] that it leaves free. It is at
    the top, or at the bottom where it would else be over [avoid]. *)

val wrap : columns:int -> rows:int -> string -> string list
(** [wrap ~columns ~rows text] is the lines of [text], in UTF-8, broken where
    they have more characters than [columns], at blanks if possible. Of more
    than [rows] lines, the last that is there says that there is more. *)
