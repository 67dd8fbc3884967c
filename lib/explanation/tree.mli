(** The tree of a ray, printed for people: a part of {!Report}. *)

open Raylab_scene
open Raylab_tracer

type style = { swatches : Swatch.t; film : Film.t }
(** The type for ways to print: patches of colour are as [film] shows them. *)

val print_ray : style -> Format.formatter -> Explain.t -> unit
(** [print_ray style ppf e] prints [e] and the rays that it sends on, numbered
    from 1 in the order in which they are cast, in a vertical box, with no line
    end after it. *)

(** {1 Parts} *)

val color : style -> Format.formatter -> Color.t -> unit
(** [color style ppf c] prints [c], of a ray, and its patch. *)

val first_line :
  Format.formatter -> int -> ('a, Format.formatter, unit, unit) format4 -> 'a
(** [first_line ppf indent format] prints a line, [indent] columns to the
    right; if it is broken, what follows stands further to the right. *)

val line :
  Format.formatter -> int -> ('a, Format.formatter, unit, unit) format4 -> 'a
(** [line ppf indent format] is likewise a line after another one. *)
