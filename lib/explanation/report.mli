(** Explanations for people: a summary, and the tree of what was done.

    The same words serve the command line, the prompt and the window. *)

open Raylab_tracer

val pp : Format.formatter -> Explain.t -> unit
(** [pp ppf e] prints {!Summary.to_string}, an empty line, and the tree, with
    no line end after it. Lines are broken at the formatter's margin.

    Rays are numbered along the chain. Each is told with what it hits, the
    surface as it is written and what it denotes, each light with its verdict,
    the mirrored ray, further to the right, and the sum that is its colour.
    Numbers are rounded; see {!Raylab_geometry.Number.pp}. *)

val pp_summary : Format.formatter -> Explain.t -> unit
(** [pp_summary] prints the summary alone. *)

val pp_tree : Format.formatter -> Explain.t -> unit
(** [pp_tree] prints the tree alone. *)

(** {1 With patches of colour} *)

val pp_with : ?swatches:Swatch.t -> Format.formatter -> Explain.t -> unit
(** [pp_with ~swatches] is {!pp} with patches of colour, by default
    {!Swatch.None}. *)

(** {1 Pixels} *)

val pp_pixel : Format.formatter -> Explain.pixel -> unit
(** [pp_pixel ppf pixel] prints {!Summary.of_pixel}, an empty line, and the
    tree of its sample. If it has several, it prints which pixel beside it is
    to blame for that, the tree of the first sample of each {!Group}, and the
    sum and the mean of all. What a ray brings is followed by what the film
    makes of it, if that is another colour. *)

val pp_pixel_with :
  ?swatches:Swatch.t ->
  ?sample:int ->
  Format.formatter ->
  Explain.pixel ->
  unit
(** [pp_pixel_with ~swatches ~sample] is {!pp_pixel} with patches of colour, as
    they are shown, and with the tree of only that sample, counted from 1.

    Raises [Failure] if there is no such sample. *)

val pp_pixel_summary_with :
  ?swatches:Swatch.t -> Format.formatter -> Explain.pixel -> unit
(** [pp_pixel_summary_with ~swatches] is the summary alone. *)
