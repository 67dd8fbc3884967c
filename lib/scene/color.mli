(** Colours as red, green and blue. *)

type t = { r : float; g : float; b : float }

val make : float -> float -> float -> t
(** [make r g b] is the colour with these channels. *)

include Color_intf.S with type t := t
(** [pp] prints [rgb 1 0.5 0]. *)

val red : t
(** [red] is (1, 0, 0). *)

val green : t
(** [green] is (0, 1, 0). *)

val blue : t
(** [blue] is (0, 0, 1). *)

val cyan : t
(** [cyan] is (0, 1, 1). *)

val magenta : t
(** [magenta] is (1, 0, 1). *)

val yellow : t
(** [yellow] is (1, 1, 0). *)

val names : (string * t) list
(** [names] is the colours that have a name in the scene language, the eight
    constants first. *)

val largest : t -> float
(** [largest c] is the largest channel of [c]. *)

val luminance : t -> float
(** [luminance c] is [0.2126 r + 0.7152 g + 0.0722 b], the brightness of [c] to
    the eye (ITU-R BT.709). *)

val require : string -> t -> unit
(** [require name c] does nothing if each channel of [c] is finite and not
    negative.

    Raises [Invalid_argument] with [name] and the channel otherwise. *)
