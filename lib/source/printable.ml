let text s =
  let out = Buffer.create (String.length s) in
  let rec copy i =
    if i < String.length s then (
      let decoded = String.get_utf_8_uchar s i in
      let code = Uchar.to_int (Uchar.utf_decode_uchar decoded) in
      if code = 0x09 then Buffer.add_char out ' '
      else if
        Character.is_unseen code || not (Uchar.utf_decode_is_valid decoded)
      then Buffer.add_utf_8_uchar out Uchar.rep
      else Buffer.add_utf_8_uchar out (Uchar.of_int code);
      copy (i + Uchar.utf_decode_length decoded))
  in
  copy 0;
  Buffer.contents out
