(* UTF-32 first: in one order of the bytes its mark starts with that of
   UTF-16. *)
let marks =
  [
    ("\xff\xfe\x00\x00", "UTF-32");
    ("\x00\x00\xfe\xff", "UTF-32");
    ("\xff\xfe", "UTF-16");
    ("\xfe\xff", "UTF-16");
  ]

let of_mark text =
  let is_of (mark, _) = String.starts_with ~prefix:mark text in
  Option.map snd (List.find_opt is_of marks)

(* One letter of UTF-32, or two of UTF-16, without a mark before. *)
let of_letters text =
  let is_nul k = text.[k] = '\x00' in
  if String.length text < 4 then None
  else
    match List.map is_nul [ 0; 1; 2; 3 ] with
    | [ true; true; true; false ] | [ false; true; true; true ] ->
        Some "UTF-32"
    | [ true; false; true; false ] | [ false; true; false; true ] ->
        Some "UTF-16"
    | _ -> None

let foreign text =
  match of_mark text with None -> of_letters text | found -> found
