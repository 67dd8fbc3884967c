(** What must hold of any text, taken for a scene. *)

val complaint : string -> string option
(** [complaint text] is what is wrong with what raylab makes of [text], or
    [None]. What is right is

    - errors, at least one, each with a place in the text, and in printing none
      of the characters that control a terminal; or
    - a scene that comes back from printing and parsing it, each pixel of
      which, in a small picture, is finite, and so is every number of its
      explanation, whose colour is the pixel's.

    An exception is a complaint too. *)

val complaint_unless_error : string -> string option
(** [complaint_unless_error text] is {!complaint}[ text]; that it is a scene is
    wrong, too. *)
