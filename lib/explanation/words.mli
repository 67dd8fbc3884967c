(** English: lists, plurals, articles and short numbers. *)

val list : string list -> string
(** [list items] is [a], [a and b] or [a, b and c]. Of more than six items only
    five are named: [a, b, c, d, e and 7 more]. *)

val lights : int list -> string
(** [lights numbers] is [light 1] or [lights 1, 2 and 3]. *)

val number : float -> string
(** [number x] is [x] with three significant digits. *)

val percent : float -> string
(** [percent x] is [x] as a part of a hundred, such as [12.5 %]. *)

val rough_percent : float -> string
(** [rough_percent x] is {!percent} with two digits, such as [96 %]. *)

val a : string -> string
(** [a phrase] is [phrase] with [a] or [an] before it. *)
