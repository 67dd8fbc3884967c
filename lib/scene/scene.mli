(** Scenes that are ready to be rendered: every number in one is known to obey
    the rules. *)

open Raylab_source

type t = private {
  camera : Camera.t;
  lens : Lens.t;
  film : Film.t;
  background : Background.t;
  ambient : Color.t;  (** the light that is everywhere *)
  ray_depth : int;
      (** rays in a chain at most, the primary ray included; at least 0 *)
  lights : Light.t list;
  objects : Object.t list;
  files : Files.t;  (** those in which the origins are *)
}
(** The type for scenes. Lights and objects are numbered by their place in
    these lists, from 1. *)

val make :
  ?lens:Lens.t ->
  ?film:Film.t ->
  ?background:Color.t ->
  ?ambient:Color.t ->
  ?ray_depth:int ->
  ?lights:Light.t list ->
  ?objects:Object.t list ->
  ?files:Files.t ->
  Camera.t ->
  t
(** [make camera] is the scene seen by [camera]. [lens] defaults to
    {!Lens.pinhole}, [film] to {!Film.default}, [background] to {!Color.black},
    [ambient], too, [ray_depth] to {!default_ray_depth}, [lights], [objects]
    and [files] to none.

    Raises [Invalid_argument] if [ray_depth] is negative or greater than
    {!max_ray_depth}, or a channel of [background] or [ambient] is negative or
    not finite. *)

val default_ray_depth : int
(** [default_ray_depth] is 4, as in the original. *)

val max_ray_depth : int
(** [max_ray_depth] is 1,000,000: a longer chain would not fit on the stack. *)

(** {1 With one thing changed}

    All else stays as it is in the scene that is given last. What {!make}
    refuses raises [Invalid_argument]. *)

val with_camera : Camera.t -> t -> t
(** [with_camera camera scene] is [scene] seen by [camera]. *)

val with_lens : Lens.t -> t -> t
(** [with_lens lens scene] is [scene] seen through this lens. *)

val with_film : Film.t -> t -> t
(** [with_film film scene] is [scene] taken on this film. *)

val with_background : Color.t -> t -> t
(** [with_background color scene] is [scene] before this background. *)

val with_sky : Background.t -> t -> t
(** [with_sky background scene] is [scene] before this background, which may
    vary. *)

val with_ambient : Color.t -> t -> t
(** [with_ambient color scene] is [scene] with this ambient light. *)

val with_ray_depth : int -> t -> t
(** [with_ray_depth n scene] is [scene] with at most [n] rays in a chain. *)

val with_lights : Light.t list -> t -> t
(** [with_lights lights scene] is [scene] with these lights instead of its own.
    Their origins are in the files of [scene], or unknown. *)

val with_objects : Object.t list -> t -> t
(** [with_objects objects scene] is [scene] with these objects instead of its
    own, likewise. *)

val without_places : t -> t
(** [without_places scene] is [scene], of no file: its lights and objects have
    no place. *)

(** {1 Places} *)

val provenance : t -> Origin.t -> Provenance.t option
(** [provenance scene origin] is what the files of [scene] tell of what is of
    this origin; [None] if that is unknown, or they do not have it. *)

(** {1 As a whole} *)

val greyscale : t -> t
(** [greyscale scene] is [scene] with every colour replaced by the grey of its
    luminance; see {!Grey}. *)

val findings : t -> Warning.t list
(** [findings scene] is what is allowed but hardly meant: no object, no light
    though a surface needs it, a ray depth of 0, a picture that distorts the
    canvas, colours from 0 to 255, glass that does not close or ends chains,
    lights that a shape keeps from all that is seen, objects in the same place.
*)

val warnings : t -> string list
(** [warnings scene] is {!findings}[ scene], a sentence each. *)

val equal : t -> t -> bool
(** [equal a b] is whether [a] and [b] are the same scene. Origins do not
    count. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints size, lights and objects, numbered, one a line; of many objects
    only the first few. *)
