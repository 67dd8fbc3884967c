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

(** {1 With options} *)

val pp_with :
  ?swatches:Swatch.t ->
  ?pixel:int * int ->
  Format.formatter ->
  Explain.t ->
  unit
(** [pp_with ~swatches ~pixel] is {!pp} with patches of colour, by default
    {!Swatch.None}, in words about the pixel [(x, y)], by default about the
    ray. *)

val pp_summary_with :
  ?swatches:Swatch.t ->
  ?pixel:int * int ->
  Format.formatter ->
  Explain.t ->
  unit
(** [pp_summary_with] is {!pp_summary}, with the options of {!pp_with}. *)

(** {1 Pixels} *)

val pp_pixel : Format.formatter -> Explain.pixel -> unit
(** [pp_pixel] is {!pp} of the pixel's sample, in words about the pixel. *)

val pp_pixel_with :
  ?swatches:Swatch.t -> Format.formatter -> Explain.pixel -> unit
(** [pp_pixel_with ~swatches] is {!pp_pixel} with patches of colour. *)

val pp_pixel_summary_with :
  ?swatches:Swatch.t -> Format.formatter -> Explain.pixel -> unit
(** [pp_pixel_summary_with ~swatches] is the summary alone. *)
