type t = {
  stage : Stage.t;
  current : Shown.t option;
  whole : Shown.t option;
  behind : Shown.t option;  (** seen where nothing is known of the latest *)
  at_once : bool;
}

let start =
  {
    stage = Reading;
    current = None;
    whole = None;
    behind = None;
    at_once = false;
  }

let stage e = e.stage
let current e = e.current
let whole e = e.whole
let is_covered { Shown.refinement; _ } = Refinement.is_covered refinement

let is_hidden { at_once; current; _ } =
  at_once && not (Option.fold ~none:false ~some:is_covered current)

(* {1 What happens} *)

let begin_ ~at_once shown ({ current; whole; behind; _ } as e) =
  let behind =
    match current with
    | Some current when is_covered current -> Some current
    | _ -> if is_hidden e then behind else whole
  in
  { e with stage = Rendering; current = Some shown; behind; at_once }

let note pass tile e =
  let was_hidden = is_hidden e in
  Option.iter
    (fun { Shown.refinement; _ } -> Refinement.note refinement pass tile)
    e.current;
  if is_hidden e then `Nothing else if was_hidden then `All else `Tile

let finish seconds e = { e with stage = Took seconds; whole = e.current }
let fail message e = { e with stage = In_error message }

(* {1 What is to be seen} *)

let subject ({ stage; current; whole; behind; _ } as e) =
  match stage with
  | In_error _ | Reading -> whole
  | Rendering | Took _ -> if is_hidden e then behind else current

let look ~size ({ stage; current; whole; behind; _ } as e) =
  let is_seen shown =
    Shown.size shown = size && Refinement.part shown.refinement > 0.
  in
  let of_first some =
    match List.filter is_seen (List.filter_map Fun.id some) with
    | [] -> None
    | seen -> Some (Shown.look seen)
  in
  match stage with
  | In_error _ -> Option.map Raster.dim (of_first [ whole ])
  | Reading -> of_first [ whole ]
  | Rendering | Took _ ->
      of_first (if is_hidden e then [ behind ] else [ current; behind ])
