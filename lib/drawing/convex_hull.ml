(* Greater than 0 if the way from [a] by [b] to [c] turns left. *)
let turn (ax, ay) (bx, by) (cx, cy) =
  ((bx -. ax) *. (cy -. ay)) -. ((by -. ay) *. (cx -. ax))

(* Half of the way around, from the first of sorted points to the last, which
   is left out. *)
let half points =
  let rec add chain p =
    match chain with
    | b :: (a :: _ as before) when turn a b p <= 0. -> add before p
    | _ -> p :: chain
  in
  match List.fold_left add [] points with _ :: rest -> rest | [] -> []

let of_points points =
  match List.sort_uniq compare points with
  | ([] | [ _ ]) as few -> few
  | sorted -> half sorted @ half (List.rev sorted)
