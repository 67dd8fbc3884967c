(** What option --stats tells. *)

open Raylab_tracer

val print : Tally.t -> Picture.t -> seconds:float -> unit
(** [print tally picture ~seconds] prints on standard error what rendering
    [picture] took: [seconds] and the rays of [tally]. *)
