(** The words of the prompt.

    They are about the current scene: the one that [raylab repl] was started
    with, or {!load} or {!use} made current since. A wrong argument raises
    [Invalid_argument] with a message that says what would be right. *)

open Raylab_geometry
open Raylab_scene
open Raylab_tracer

val help : unit -> unit
(** [help ()] lists these words, with a line on each, and shows how a scene is
    built from those of {!Build}. *)

(** {1 The scene} *)

val scene : unit -> Scene.t
(** [scene ()] is the current scene. *)

val load : ?time:float -> string -> unit
(** [load ~time file] reads a scene file at [time], by default 0, says what is
    in it, and what is hardly meant in it, and makes it the current scene. If
    it is in error, that is told as the command line does, and the scene stays
    as it was. *)

val use : Scene.t -> unit
(** [use scene] makes [scene] the current one, and says what is hardly meant in
    it. *)

(** {1 One ray} *)

val why : int -> int -> unit
(** [why x y] prints in a sentence why pixel (x, y) has its colour; x counts
    from the left and y from the top, both from 0. *)

val pixel : int -> int -> Explain.pixel
(** [pixel x y] is why pixel (x, y) has its colour, in full. *)

val primary : int -> int -> Ray.t
(** [primary x y] is the ray that looks through pixel (x, y). *)

val sample : int -> int -> int -> Ray.t
(** [sample x y k] is the ray of sample [k] of pixel (x, y), from 1 to as many
    as the scene takes of a pixel at most. The first is {!primary}. *)

val trace : Ray.t -> Color.t
(** [trace ray] is the colour that [ray] brings. *)

val hit : Ray.t -> Hit.t option
(** [hit ray] is the first hit of [ray]. *)

val explain : Ray.t -> Explain.t
(** [explain ray] is why [ray] brings its colour. *)

(** {1 Step by step} *)

val steps : Ray.t -> Event.t Seq.t
(** [steps ray] is all that the tracer does to find the colour of [ray], in
    order, and takes the walk of {!next} before the first of it. *)

val next : unit -> Event.t
(** [next ()] is the next step of the walk. *)

val back : unit -> Event.t
(** [back ()] undoes one {!next}: it is the step before. *)

(** {1 The picture}

    Whole pictures are rendered by the native program if the prompt was started
    by it, and otherwise in the prompt, which is much slower; see {!Native}. *)

val render : unit -> Picture.t
(** [render ()] is the picture of the current scene. *)

val show : unit -> unit
(** [show ()] shows the current scene in a window, as [raylab view] does, until
    that is closed. Its key s saves the picture beside the file that the scene
    was loaded from, or else as [scene.bmp]. *)

val save : string -> unit
(** [save file] renders the current scene and writes the picture to [file], as
    BMP, PNG or PPM by its extension: the very file that [raylab render]
    writes.

    Raises [Sys_error] if it could not be written. *)
