(** Explanations for people: a summary, and the tree of what was done.

    The same words serve the command line, the prompt and the window. *)

open Raylab_tracer

val pp :
  ?swatches:Swatch.t ->
  ?pixel:int * int ->
  Format.formatter ->
  Explain.t ->
  unit
(** [pp ppf e] prints {!Summary.to_string}, an empty line, and the tree, with
    no line end after it. Lines are broken at the formatter's margin.

    Rays are numbered along the chain. Each is told with what it hits, the
    surface as it is written and what it denotes, each light with its verdict,
    the mirrored ray, further to the right, and the sum that is its colour.
    Numbers are rounded; see {!Raylab_geometry.Number.pp}. [swatches] is
    {!Swatch.None} by default. *)

val pp_summary :
  ?swatches:Swatch.t ->
  ?pixel:int * int ->
  Format.formatter ->
  Explain.t ->
  unit
(** [pp_summary] prints the summary alone. *)

val pp_tree : ?swatches:Swatch.t -> Format.formatter -> Explain.t -> unit
(** [pp_tree] prints the tree alone. *)
