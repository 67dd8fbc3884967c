(** The registers that one domain works with while it evaluates rays.

    They are records of mutable doubles, because in OCaml a double that crosses
    a function call or lies in an ordinary record costs an allocation, and a
    picture has millions of them. Nobody but {!Evaluator} and its parts sees
    them. *)

open Raylab_geometry
open Raylab_scene

type t = {
  prepared : Prepared.t;
  surfaces : Surfaces.t;  (** those of [prepared] *)
  observe : (Event.t -> unit) option;  (** who is told of every event *)
  finder : Finder.t;
  shadow_finder : Finder.t;  (** of what shadow rays meet *)
  tally : Tally.t;
  ray : Raw_ray.t;  (** the ray of the chain *)
  shadow_ray : Raw_ray.t;
  meeting : Meeting.t;  (** what one of the two meets *)
  spot : Spot.t;  (** where the ray of the chain does *)
  lobes : Raw_lobes.t;  (** what a surface that varies denotes there *)
  machines : Surface.machines option array;
      (** those of [surfaces.patterned], once they are needed *)
  background : Background.reader;
  incidence : Light.incidence;  (** how one light meets it *)
  light : Raw_color.t;  (** what all lights give *)
  color : Raw_color.t;  (** what the ray brings *)
}
(** The type for registers. *)

val create : ?observe:(Event.t -> unit) -> Prepared.t -> t
(** [create prepared] is new registers for this scene. *)

val machines : t -> int -> Surface.machines
(** [machines t row] is the machines of the surface with this row, which
    varies. *)

val load : t -> Ray.t -> unit
(** [load t ray] puts [ray] into its register. *)
