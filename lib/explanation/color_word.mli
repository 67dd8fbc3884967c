(** Words for colours. *)

open Raylab_scene

val of_color : Color.t -> string
(** [of_color c] is the simple word for [c] as a picture shows it, each channel
    at most 1. With [v] its largest channel, [d] the difference to the smallest
    and [h] the hue in degrees (red 0, green 120, blue 240) it is

    - [black] if [v < 0.08];
    - if [d < 0.15 v], [white] if [v > 0.9], [light grey] if [v > 0.65], [grey]
      if [v > 0.3], else [dark grey];
    - else, by hue, [red], [orange] from 15, [yellow] from 42, [green] from 70,
      [cyan] from 165, [blue] from 195, [purple] from 255, [magenta] from 290
      and [red] again from 345, with [dark] before it if [v <= 0.5], or [light]
      if [d < 0.5 v]. Dark orange is [brown], and so is dark yellow up to 50;
      light orange is [beige], light red [pink]. *)

val hue : Color.t -> float option
(** [hue c] is the hue that {!of_color} goes by, from 0 to 360; [None] for what
    it calls black, white or grey. *)

val of_glow : Color.t -> bool * string
(** [of_glow c] is the word for what emits [c], and whether it does so faintly:
    what {!of_color} calls black has the word that a brighter [c] would have.
    Without any light it is [black], and not faint. *)
