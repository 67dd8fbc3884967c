(** The rays in a picture of a path. *)

open Raylab_tracer

val draw : View.t -> Explain.t -> Drawn.t
(** [draw view e] is the rays of [e], numbered along the chain, and a dot at
    each hit in the colour that came of it. A ray that leaves the panel says
    where it goes. Shadow rays are dashed; a blocked one ends in a cross. At
    most 200 rays are drawn. *)

val directional_lights : Explain.t -> int list
(** [directional_lights e] is the numbers of the directional lights that
    {!draw} shows, by an arrow where the light comes in. *)
