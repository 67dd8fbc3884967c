let of_utf_8 text =
  let buffer = Buffer.create (String.length text) in
  let rec add at =
    if at < String.length text then (
      let decoded = String.get_utf_8_uchar text at in
      (match Uchar.to_int (Uchar.utf_decode_uchar decoded) with
      | c when (c >= 0x20 && c < 0x7f) || c = 0x0a ->
          Buffer.add_char buffer (Char.chr c)
      | _ -> Buffer.add_char buffer '?');
      add (at + Uchar.utf_decode_length decoded))
  in
  add 0;
  Buffer.contents buffer

(* at blanks, where there are any *)
let rec break columns line =
  let length = String.length line in
  if length <= columns then [ line ]
  else
    let first, rest =
      match String.rindex_from_opt line columns ' ' with
      | Some blank when blank > 0 -> (blank, blank + 1)
      | _ -> (columns, columns)
    in
    String.sub line 0 first
    :: break columns (String.sub line rest (length - rest))

let wrap ~columns ~rows text =
  if columns < 1 || rows < 1 then []
  else
    let lines =
      List.concat_map (break columns)
        (String.split_on_char '\n' (of_utf_8 text))
    in
    if List.compare_length_with lines rows <= 0 then lines
    else List.filteri (fun k _ -> k < rows - 1) lines @ [ "..." ]
