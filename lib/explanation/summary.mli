(** One sentence that says why a ray has its colour.

    Such as
    [a mirror (sphere 4, line 34) that shows the red sphere (object 2, line
     30), lit by light 1, in the shadow of sphere 3 (line 32) from light 2]. It
    names what is hit, the lights that reach it, those that are blocked, and by
    what, and those that it is turned away from; and follows mirrors. Of long
    chains it tells both ends. If a diffusive surface stays black it says why,
    and also if a channel is brighter than a picture can show. *)

open Raylab_tracer

val reason : Explain.t -> string
(** [reason e] is the sentence about [e], on one line, without a full stop. *)

val subject : ?pixel:int * int -> Explain.t -> string
(** [subject ~pixel:(320, 240) e] is [pixel (320, 240) is rgb 200 75 49], with
    the bytes that a picture shows; without a pixel it starts with [the ray].
*)

val of_pixel : Explain.pixel -> string
(** [of_pixel pixel] is the sentence about [pixel], with its bytes before it.
*)

val to_string : ?pixel:int * int -> Explain.t -> string
(** [to_string ~pixel e] is {!subject}, a colon, and {!reason}. *)
