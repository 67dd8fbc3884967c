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
