(** What is beside the window: where it writes what there is to read. *)

open Raylab_tracer

type t = {
  print : string -> unit;  (** shows lines that were asked for *)
  tell : string -> unit;  (** shows a message *)
  explain : Explain.pixel -> unit;  (** shows why a pixel is so *)
}
(** The type for terminals. *)

val make : out_channel -> tell:(string -> unit) -> t
(** [make channel ~tell] writes what was asked for to [channel], and leaves
    messages, which may have several lines, to [tell]. Explanations have
    patches of colour if [channel] is a terminal that can show them. If
    [channel] cannot be written to, nobody is reading, and that is no error. *)
