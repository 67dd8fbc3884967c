(** In a sentence: which colour a ray or a pixel has, and why. *)

open Raylab_tracer

val subject : Explain.t -> string
(** [subject e] is [the ray is rgb 200 75 49], with the bytes that a picture
    would show. *)

val to_string : Explain.t -> string
(** [to_string e] is {!subject}, a colon, and {!Reason.of_ray}. *)

(** {1 Pixels} *)

val pixel_subject : Explain.pixel -> string
(** [pixel_subject pixel] is [pixel (320, 240) is rgb 200 75 49]. *)

val pixel_reason : Explain.pixel -> string
(** [pixel_reason pixel] is {!Reason.of_ray} if [pixel] has one sample, and
    otherwise what its {{!Group}groups} see:
    [9 of 16 samples see the red sphere (object 2, line 30), in the shadow of
     sphere 3 (line 32) from light 1; 7 see the blue background], and how many
    are over-exposed. Of many groups only the largest are told. *)

val of_pixel : Explain.pixel -> string
(** [of_pixel pixel] is {!pixel_subject}, a colon, and {!pixel_reason}. *)
