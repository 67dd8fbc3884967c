(** Whole pictures, by the native program.

    A prompt runs bytecode, which renders some 17 times slower than native
    code. So whole pictures are left to the [raylab] that started the prompt:
    it gets the scene by {!Handover}, in a temporary file that only its user
    can read, and gives the picture back. It is the same tracer, so the picture
    is the same, bit for bit. *)

open Raylab_scene
open Raylab_tracer

val variable : string
(** [variable] is the environment variable by which [raylab repl] says where it
    is itself: ["RAYLAB_PROGRAM"]. *)

val picture : Scene.t -> Picture.t
(** [picture scene] is the picture of [scene], made by the native program, or
    here if there is none. The program shows its progress on a terminal.

    Raises [Sys_error] if the picture would not fit into memory. Raises
    [Failure] if the program ends without a picture. Raises [Sys.Break] if it
    is interrupted. *)

val show : ?file:string -> ?time:float -> Scene.t -> unit
(** [show ~file ~time scene] shows [scene], which came from [file] as that is
    at [time], by default 0, in a window of the native program, or of this one
    if there is none, until the window is closed. If [file] still describes
    [scene], at time 0, it is [file] that is shown. If there is no display that
    is told on standard error.

    Raises [Sys_error] if the picture would not fit into memory. Raises
    [Failure] if the program fails. Raises [Sys.Break] if it is interrupted. *)
