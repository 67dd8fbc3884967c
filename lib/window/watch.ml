open Raylab_viewer

type t = { path : string; mutable seen : Unix.stats Changes.t }

(* all that a look at the file does not change *)
let stamp path =
  match Unix.stat path with
  | stats -> Some { stats with st_atime = 0. }
  | exception Unix.Unix_error _ -> None

let start path = { path; seen = Changes.initial (stamp path) }

let has_changed watch =
  let now = Unix.gettimeofday () in
  let seen, changed = Changes.step ~now (stamp watch.path) watch.seen in
  watch.seen <- seen;
  changed
