open Raylab_viewer

(* all that a look at the file does not change *)
let stamp path =
  match Unix.stat path with
  | stats -> Some { stats with st_atime = 0. }
  | exception Unix.Unix_error _ -> None

let first_look path = (path, Changes.initial (stamp path))

type seen = (string * Unix.stats Changes.t) list

type t = {
  first : string * Unix.stats Changes.t;
  followed : seen Atomic.t; (* as they were when they were first followed *)
  mutable seen : seen; (* as they were at the last look *)
}

let start path =
  { first = first_look path; followed = Atomic.make []; seen = [] }

let follow watch paths = Atomic.set watch.followed (List.map first_look paths)

let has_changed watch =
  let now = Unix.gettimeofday () in
  let look (path, first) =
    let last = Option.value ~default:first (List.assoc_opt path watch.seen) in
    let seen, changed = Changes.step ~now (stamp path) last in
    ((path, seen), changed)
  in
  let looks = List.map look (watch.first :: Atomic.get watch.followed) in
  watch.seen <- List.map fst looks;
  List.exists snd looks
