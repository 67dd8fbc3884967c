(** The same scenes by POV-Ray 3.7, where it is installed.

    POV-Ray's own statistics tell the time of its parts. Its trace time is the
    figure to compare with: rendering alone, over all threads, in steps of a
    millisecond. The processor time of the whole process gives the same, less
    sharply, after parsing, bounding and {!overhead} are taken off; with many
    objects it comes out too large, since it has the time in it that it takes
    to free them. The wall time of the process tells nothing: POV-Ray sleeps
    for half a second and more before it ends. *)

open Raylab_scene

val version : unit -> string option
(** [version ()] is the version of the [povray] that a shell would find, such
    as ["3.7.0.10"], or [None] if there is none that runs. *)

val write : out_channel -> Scene.t -> unit
(** [write channel scene] writes [scene] in POV-Ray's language: the same
    camera, shapes, surfaces and length of chains. A directional light becomes
    a parallel light far away. A spherical light gets POV-Ray's fall-off
    [2 / (1 + (d / f)^2)] with an [f] so small that this is [2 (f / d)^2].

    @raise Invalid_argument
      if a surface is both luminous and diffusive, which POV-Ray cannot say of
      every pair of colours. *)

type t = {
  parse : Child.clock;
  bounding : Child.clock;  (** building its hierarchy of boxes *)
  trace : Child.clock;  (** rendering *)
  process : Child.clock;  (** the whole process *)
  rays : int;  (** primary and reflected ones *)
  shadow_rays : int;
}
(** The type for what POV-Ray says of one run. *)

val empty : string
(** [empty] is a POV-Ray scene with nothing in it. *)

val overhead : t list -> float
(** [overhead runs] is the processor seconds that POV-Ray takes beside reading
    and rendering: what its process takes for an {!empty} scene over what it
    takes to trace it, of which [runs] are. NaN if there are none. *)

val trace_by_difference : overhead:float -> t list -> float
(** [trace_by_difference ~overhead runs] is the processor seconds to render, by
    the processor time of the whole process: a check on [trace]. *)

val render :
  ?picture:string ->
  threads:int ->
  width:int ->
  height:int ->
  string ->
  (t, string) result
(** [render ~threads ~width ~height path] renders the POV-Ray scene at [path]
    in this size without antialiasing and writes the result, without gamma, to
    the file [picture] if there is one: as PPM if that is its extension, else
    as PNG. *)
