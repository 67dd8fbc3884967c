open Raylab_tracer

(* The events seen, the last one first, each with what follows it. *)
type t = { seen : (Event.t * Event.t Seq.t) list; coming : Event.t Seq.t }

let start coming = { seen = []; coming }

let next { seen; coming } =
  match coming () with
  | Seq.Nil -> None
  | Cons (event, coming) ->
      Some (event, { seen = (event, coming) :: seen; coming })

let back { seen; _ } =
  match seen with
  | _ :: ((event, coming) :: _ as seen) -> Some (event, { seen; coming })
  | _ -> None
