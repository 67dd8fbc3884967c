(** Checks of words that follow one another in the text.

    The syntax of lights and objects keeps no places, only values, which is a
    third of the memory. Each check here takes the words that a value was read
    from, and so knows the place of whatever it finds wrong. *)

open Raylab_geometry
open Raylab_scene

type t
(** The type for places between words, which the checks move on. *)

val start : Findings.t -> int -> t
(** [start findings offset] is before the first word at [offset] or after. *)

val skip_keyword : t -> unit
(** [skip_keyword words] takes a word that is right. *)

val refuse : t -> ?advice:string -> string -> unit
(** [refuse words ~advice message] takes a word, which is wrong. *)

val number : t -> Number.rule -> string -> float -> unit
(** [number words rule name value] takes the word of [value], which is called
    [name] and must obey [rule]. *)

val vector : t -> string -> Vec3.t -> unit
(** [vector words name vector] takes the three words of [vector]. *)

val direction : t -> string -> Vec3.t -> unit
(** [direction words name vector] is {!val-vector}, of one that must not be the
    zero vector. *)

val color : t -> string -> Color.t -> unit
(** [color words name color] takes the name of [color], or its three numbers.
*)
