(** The rays of a path in a panel. *)

val draw : Panel.t -> Path.t -> Sketch.t
(** [draw panel path] is the rays of [path], those of the chain with their
    numbers, and a dot at each hit in the colour that came of it. A ray that
    leaves the panel says where it goes. A blocked shadow ray ends in a cross.
    At most 200 rays and 200 hits are drawn. *)

val lights_shown : Path.t -> int list
(** [lights_shown path] is the numbers of the directional lights that {!draw}
    shows, by an arrow where the light comes in. *)
