open Raylab_scene

let keywords : (string * Parser.token) list =
  [
    ("imWidth", IM_WIDTH);
    ("imHeight", IM_HEIGHT);
    ("canvWidth", CANV_WIDTH);
    ("canvHeight", CANV_HEIGHT);
    ("depth", DEPTH);
    ("bcolor", BCOLOR);
    ("bgcolor", BCOLOR);
    ("raydepth", RAYDEPTH);
    ("lights", LIGHTS);
    ("directional", DIRECTIONAL);
    ("spherical", SPHERICAL);
    ("objects", OBJECTS);
    ("sphere", SPHERE);
    ("plane", PLANE);
    ("diffusive", DIFFUSIVE);
    ("reflective", REFLECTIVE);
    ("luminous", LUMINOUS);
    ("mixed", MIXED);
  ]

let colors = List.map (fun (name, c) -> (name, Parser.COLOR c)) Color.names
let all = keywords @ colors

let table =
  let add (word, token) = (String.lowercase_ascii word, token) in
  Hashtbl.of_seq (Seq.map add (List.to_seq all))

let token word = Hashtbl.find_opt table (String.lowercase_ascii word)

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

let longest =
  List.fold_left (fun n (word, _) -> Int.max n (String.length word)) 0 all

let nearest word ~among =
  let word = String.lowercase_ascii word in
  let length = String.length word in
  (* a word this long is not near to any keyword, and might be a megabyte *)
  if length > 2 * longest then None
  else
    let rank keyword =
      (distance word (String.lowercase_ascii keyword), keyword)
    in
    match List.sort compare (List.map rank among) with
    | (d, keyword) :: _ when d <= Int.max 1 (length / 2) -> Some keyword
    | _ -> None
