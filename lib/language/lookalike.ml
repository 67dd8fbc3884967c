type t = { start : int; stop : int; name : string; meant : string }

(* What a byte is in the old encodings of Windows. *)
let meant_by_byte = function
  | '\x91' | '\x92' -> "'"
  | '\x93' | '\x94' -> "\""
  | '\x96' | '\x97' -> "-"
  | '\xa0' -> " "
  | '\xad' -> ""
  | byte -> String.make 1 byte

let at text start =
  let decoded = String.get_utf_8_uchar text start in
  let stop = start + Uchar.utf_decode_length decoded in
  if Uchar.utf_decode_is_valid decoded then
    let code = Uchar.to_int (Uchar.utf_decode_uchar decoded) in
    let found (name, meant) =
      { start; stop; name = Printf.sprintf "U+%04X, %s" code name; meant }
    in
    (stop, Option.map found (Raylab_source.Character.strange code))
  else
    let byte = text.[start] in
    let name =
      Printf.sprintf "byte %02X, which is no UTF-8" (Char.code byte)
    in
    let stop = start + 1 in
    (stop, Some { start; stop; name; meant = meant_by_byte byte })

let first text =
  let rec find i =
    if i = String.length text then None
    else
      match at text i with
      | _, (Some _ as found) -> found
      | stop, None -> find stop
  in
  find 0

let plain text =
  let out = Buffer.create (String.length text) in
  let rec copy i =
    if i < String.length text then (
      let stop, found = at text i in
      (match found with
      | Some { meant; _ } -> Buffer.add_string out meant
      | None -> Buffer.add_substring out text i (stop - i));
      copy stop)
  in
  copy 0;
  Buffer.contents out
