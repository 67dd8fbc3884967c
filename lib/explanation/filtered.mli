(** Light that went through something, in words. *)

open Raylab_tracer

val clause : exact:bool -> Explain.light -> string option
(** [clause ~exact light] is
    [in a green shadow: light 2 went through sphere 2 (line 7)], or how much of
    a light came out, if that is [exact] and has no hue; [None] if the light
    met nothing that it goes through. *)
