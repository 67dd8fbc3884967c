(* A part is a member by its number, or gate [k] as [-1 - k]. *)
type t = {
  need : int array;
  parts : int array array;
  parent : int array; (* of each gate; -1 of the whole, which is gate 0 *)
  weight : int array; (* of each gate in its parent *)
  gate : int array; (* of each member *)
  member_weight : int array; (* of each member in its gate *)
  flipped : bool array;
}

type shape =
  | Member of int
  | Gate of { need : int; parts : (int * shape) list }

(* {1 Making them} *)

type draft = {
  mutable next : int;
  mutable made : (int * int * int array * int * int) list;
      (* each gate, what it needs, its parts, its parent and weight *)
  member_gates : int array;
  member_weights : int array;
  is_flipped : bool array;
}

let rec add draft ~parent ~weight ~flipped = function
  | Member m ->
      draft.member_gates.(m) <- parent;
      draft.member_weights.(m) <- weight;
      draft.is_flipped.(m) <- flipped;
      m
  | Gate { need; parts } ->
      let gate = draft.next in
      draft.next <- gate + 1;
      let part (weight, shape) =
        let flipped = flipped <> (weight < 0) in
        add draft ~parent:gate ~weight ~flipped shape
      in
      let parts = Array.of_list (List.map part parts) in
      draft.made <- (gate, need, parts, parent, weight) :: draft.made;
      -1 - gate

let make ~members shape =
  let draft =
    {
      next = 0;
      made = [];
      member_gates = Array.make members 0;
      member_weights = Array.make members 1;
      is_flipped = Array.make members false;
    }
  in
  ignore (add draft ~parent:(-1) ~weight:1 ~flipped:false shape : int);
  let made = List.sort compare draft.made in
  let all pick = Array.of_list (List.map pick made) in
  {
    need = all (fun (_, need, _, _, _) -> need);
    parts = all (fun (_, _, parts, _, _) -> parts);
    parent = all (fun (_, _, _, parent, _) -> parent);
    weight = all (fun (_, _, _, _, weight) -> weight);
    gate = draft.member_gates;
    member_weight = draft.member_weights;
    flipped = draft.is_flipped;
  }

let count gates = Array.length gates.need
let flipped gates = gates.flipped

(* {1 Points} *)

let[@inline] is_gate_up gates (counts : int array) gate =
  counts.(gate) >= gates.need.(gate)

let is_up gates counts = is_gate_up gates counts 0

let rec change gates counts gate by =
  let was_up = is_gate_up gates counts gate in
  counts.(gate) <- counts.(gate) + by;
  let is_up = is_gate_up gates counts gate in
  let parent = gates.parent.(gate) in
  if is_up <> was_up && parent >= 0 then
    let weight = gates.weight.(gate) in
    change gates counts parent (if is_up then weight else -weight)

let pass gates counts ~member ~enters =
  let weight = gates.member_weight.(member) in
  change gates counts gates.gate.(member) (if enters then weight else -weight)

(* {1 The first that made it change} *)

let direction gates ~before ~after gate =
  Bool.compare (is_gate_up gates after gate) (is_gate_up gates before gate)

let rec first gates ~before ~after ~(moved : int array) gate up k =
  let part = gates.parts.(gate).(k) in
  let moves, weight =
    if part >= 0 then (moved.(part), gates.member_weight.(part))
    else
      let inner = -1 - part in
      (direction gates ~before ~after inner, gates.weight.(inner))
  in
  if moves * weight <> up then first gates ~before ~after ~moved gate up (k + 1)
  else if part >= 0 then part
  else first gates ~before ~after ~moved (-1 - part) moves 0

let standing gates ~before ~after ~moved =
  first gates ~before ~after ~moved 0 (direction gates ~before ~after 0) 0
