(** What the things of a scene are called. *)

open Raylab_scene
open Raylab_tracer

val place : Provenance.t option -> string
(** [place p] is [, line 30], or nothing if there is no place. *)

val by_number :
  ?primitive:Explain.primitive ->
  int ->
  Object.t ->
  Provenance.t option ->
  string
(** [by_number k o place] is [sphere 3 (line 24)], for the object [o] of number
    [k], which is at [place]. Of a [primitive] of a solid it is
    [box 5.1 (line 11) of difference 5 (line 10)], or, if that is taken away,
    [the inside of difference 5 (line 10), cut by sphere 5.2 (line 12)]. *)

val with_part : Raylab_geometry.Shape.t -> int -> string -> string
(** [with_part shape k name] is [the top of box 3] where [shape], which goes by
    [name], is a box and its part [k] the top, and [name] where a part has no
    word of its own. *)

val by_look :
  ?primitive:Explain.primitive ->
  int ->
  Object.t ->
  Surface.t ->
  Provenance.t option ->
  string
(** [by_look k o surface place] says what [o] looks like with this surface, and
    then which one it is, without an article: [red sphere (object 2, line 30)],
    [mirror (sphere 4, line 34)],
    [mix of 85 % yellow and 15 % mirror (sphere 9, line 32)],
    [luminous white sphere (object 4)],
    [red sphere (object 5.1, line 11) of union 5 (line 10)],
    [red inside of difference 5 (line 10), cut by sphere 5.2 (line 12)]. The
    words depend on what the surface denotes: it makes no difference how mixes
    nest, and what glows is not reckoned in parts. *)

val here : Surface.t -> here:Surface.t -> string
(** [here surface ~here] says that [surface], which varies, is [here] at some
    point: [the checker is white], [the checker is a mirror]. *)

val background : Color.t -> string
(** [background c] is [blue background]. *)
