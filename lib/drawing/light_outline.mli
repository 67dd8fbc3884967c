(** The outlines of lights with a size, in a panel. *)

open Raylab_geometry
open Raylab_scene

val middle : Pane.t -> Vec3.t
(** [middle pane] is the point in the middle of [pane]. *)

val pane : Drawing.look -> Panel.t -> Pane.t -> Drawing.t
(** [pane look panel p] is [p] as [panel] shows it: its sides as far as they
    are in the panel, and what is between them if all is. *)

val cone : Drawing.ink -> Panel.t -> Beam.t -> Drawing.t
(** [cone ink panel beam] is the outline of the outer cone of [beam], as far as
    its target is away; nothing if that cone is as wide as half of space. *)
