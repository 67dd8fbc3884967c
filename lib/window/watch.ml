type 'stamp state = { seen : 'stamp option; away_since : float option }

let patience = 1.
let initial seen = { seen; away_since = None }

let step ~now stamp state =
  match (stamp, state) with
  | Some _, _ -> ({ seen = stamp; away_since = None }, stamp <> state.seen)
  | None, { seen = None; _ } -> (state, false)
  | None, { away_since = None; _ } ->
      ({ state with away_since = Some now }, false)
  | None, { away_since = Some since; _ } ->
      if now -. since < patience then (state, false)
      else ({ seen = None; away_since = None }, true)

type t = { path : string; mutable state : Unix.stats state }

(* all that a look at the file does not change *)
let stamp path =
  match Unix.stat path with
  | stats -> Some { stats with st_atime = 0. }
  | exception Unix.Unix_error _ -> None

let start path = { path; state = initial (stamp path) }

let has_changed watch =
  let now = Unix.gettimeofday () in
  let state, changed = step ~now (stamp watch.path) watch.state in
  watch.state <- state;
  changed
