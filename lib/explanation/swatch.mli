(** Colour swatches: patches of colour on a terminal. *)

open Raylab_scene

type t =
  | None  (** not to be shown *)
  | Palette
      (** the nearest of a terminal's 256 colours that has the colour's hue,
          within 15 degrees, or none *)
  | True_color  (** 24 bits a colour *)

val detect : is_terminal:bool -> (string -> string option) -> t
(** [detect ~is_terminal getenv] is what an output that [is_terminal] can show,
    where [getenv] looks up environment variables: {!None} unless it is a
    terminal whose [TERM] is neither missing nor [dumb], and [NO_COLOR] is
    missing or empty; {!True_color} if [COLORTERM] is [truecolor] or [24bit],
    but not within GNU screen, which knows no such colours; else {!Palette}. *)

val pp_with : t -> Format.formatter -> Color.t -> unit
(** [pp_with swatch ppf c] prints a blank and a patch, two columns wide, of the
    colour that a picture shows for [c]; or nothing if [swatch] is {!None}. *)
