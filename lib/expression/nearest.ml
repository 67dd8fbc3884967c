(* Levenshtein's distance, row by row. *)
let distance a b =
  let row = Array.init (String.length b + 1) Fun.id in
  String.iteri
    (fun i letter ->
      let diagonal = ref row.(0) in
      row.(0) <- i + 1;
      String.iteri
        (fun j letter' ->
          let replaced = !diagonal + if letter = letter' then 0 else 1 in
          diagonal := row.(j + 1);
          row.(j + 1) <- Int.min replaced (1 + Int.min row.(j) row.(j + 1)))
        b)
    a;
  row.(String.length b)

let find word ~among =
  let word = String.lowercase_ascii word in
  let length = String.length word in
  let longest =
    List.fold_left (fun n word -> Int.max n (String.length word)) 0 among
  in
  (* a word this long is near to none, and might be a megabyte *)
  if length > 2 * longest then None
  else
    let rank known = (distance word (String.lowercase_ascii known), known) in
    match List.sort compare (List.map rank among) with
    | (d, known) :: _ when d <= Int.max 1 (length / 2) -> Some known
    | _ -> None
