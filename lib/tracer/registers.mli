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
  shadow_finder : Finder.t;  (** of what ends shadow rays *)
  tally : Tally.t;
  ray : Raw_ray.t;  (** the ray of the chain *)
  shadow_ray : Raw_ray.t;
  meeting : Meeting.t;  (** what one of the two meets *)
  spot : Spot.t;  (** where the ray of the chain does *)
  lobes : Raw_lobes.t;  (** what a surface that varies denotes there *)
  bounces : Bounces.t;  (** the rays that are still to be followed *)
  incidence : Incidence.t;  (** how one light meets it *)
  clear_finder : Finder.t option;
      (** of what shadow rays may go through, if there is such *)
  passing : Raw_ray.t;  (** the shadow ray behind what it has gone through *)
  shadow_spot : Spot.t;  (** where it meets the next of that *)
  shadow_lobes : Raw_lobes.t;  (** what a surface that varies denotes there *)
  part : Raw_color.t;  (** what that lets through *)
  tint : Raw_color.t;  (** what all of that together does *)
  mutable crossings : Event.crossing list;
      (** all of that, the last first; kept for observers only *)
  gives : Raw_color.t;  (** what one light gives *)
  mean : Raw_color.t;  (** what the points of a light give *)
  no_highlights : Raw_parts.t;  (** those of a plain surface: none *)
  shine : Shine.t;  (** what all lights give to the highlights *)
  mean_shine : Shine.t;  (** what the points of a light give to them *)
  gives_shine : Shine.t;  (** what one of them does *)
  machines : Surface.machines option array;
      (** those of [surfaces.patterned], once they are needed *)
  background : Background.reader;
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
