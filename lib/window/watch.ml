type 'stamp state = {
  told : 'stamp option;
  last : 'stamp option;
  since : float; (* when [last] was first seen *)
}

let settling = 0.05
let patience = 1.
let initial stamp = { told = stamp; last = stamp; since = neg_infinity }

let step ~now stamp state =
  let state =
    if stamp = state.last then state
    else { state with last = stamp; since = now }
  in
  let enough = if stamp = None then patience else settling in
  if stamp <> state.told && now -. state.since >= enough then
    ({ state with told = stamp }, true)
  else (state, false)

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
