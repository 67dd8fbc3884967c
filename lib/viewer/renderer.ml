type t = {
  start : unit -> Rendering.t;
  mutable under_way : Rendering.t option;
  mutable is_wanted : bool;  (** a new one, once that under way has ended *)
}

let make start = { start; under_way = None; is_wanted = false }

let restart r =
  r.is_wanted <- true;
  Option.iter Rendering.stop r.under_way

let is_busy r = r.is_wanted || Option.is_some r.under_way

let finish r =
  Option.iter
    (fun rendering ->
      Rendering.stop rendering;
      r.under_way <- None;
      Rendering.join rendering)
    r.under_way

let news r =
  match r.under_way with
  | Some rendering ->
      let is_over = Rendering.is_over rendering in
      let news = Rendering.news rendering in
      if is_over then finish r;
      (* what a stopped rendering still has to tell does not matter *)
      if r.is_wanted then [] else news
  | None ->
      if r.is_wanted then (
        r.is_wanted <- false;
        r.under_way <- Some (r.start ()));
      []
