type t = {
  mutable under_way : Rendering.t option;
  mutable wanted : (unit -> Rendering.t) option;
      (** the next one, once that under way has ended *)
}

let make () = { under_way = None; wanted = None }

let restart r start =
  r.wanted <- Some start;
  Option.iter Rendering.stop r.under_way

let is_busy r = Option.is_some r.wanted || Option.is_some r.under_way
let is_turning r = Option.is_some r.wanted && Option.is_some r.under_way

let finish r =
  Option.iter
    (fun rendering ->
      Rendering.stop rendering;
      r.under_way <- None;
      Rendering.join rendering)
    r.under_way

let start_wanted r =
  match (r.under_way, r.wanted) with
  | None, Some start ->
      r.wanted <- None;
      r.under_way <- Some (start ())
  | _ -> ()

let news r =
  let told =
    match r.under_way with
    | None -> []
    | Some rendering ->
        let is_over = Rendering.is_over rendering in
        let news = Rendering.news rendering in
        if is_over then finish r;
        (* what a stopped rendering still has to tell does not matter *)
        if Option.is_some r.wanted then [] else news
  in
  start_wanted r;
  told
