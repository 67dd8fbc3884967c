(** What the things of a scene are called. *)

open Raylab_scene

val place : Provenance.t option -> string
(** [place p] is [, line 30], or nothing if there is no place. *)

val by_number : int -> Object.t -> Provenance.t option -> string
(** [by_number k o place] is [sphere 3 (line 24)], for the object [o] of number
    [k], which is at [place]. *)

val with_part : Raylab_geometry.Shape.t -> int -> string -> string
(** [with_part shape k name] is [the top of box 3] where [shape], which goes by
    [name], is a box and its part [k] the top, and [name] where a part has no
    word of its own. *)

val by_look : int -> Object.t -> Provenance.t option -> string
(** [by_look k o place] says what [o] looks like, and then which one it is,
    without an article: [red sphere (object 2, line 30)],
    [mirror (sphere 4, line 34)],
    [mix of 85 % yellow and 15 % mirror (sphere 9, line 32)],
    [luminous white sphere (object 4)]. The words depend on what the surface
    denotes: it makes no difference how mixes nest, and what glows is not
    reckoned in parts. *)

val background : Color.t -> string
(** [background c] is [blue background]. *)
