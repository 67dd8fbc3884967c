(* Codes from the first to the last of a row, and what one is called; then also
   what it was meant for. *)

let unseen =
  let unseen = "an invisible character" in
  [
    (0x00, 0x00, "a NUL");
    (0x01, 0x1f, "a control character");
    (0x7f, 0x84, "a control character");
    (0x86, 0x9f, "a control character");
    (0xad, 0xad, "a soft hyphen");
    (0x34f, 0x34f, unseen);
    (0x61c, 0x61c, "a mark of direction");
    (0x115f, 0x1160, unseen);
    (0x17b4, 0x17b5, unseen);
    (0x180b, 0x180f, unseen);
    (0x200b, 0x200b, "a zero-width space");
    (0x200c, 0x200c, "a zero-width non-joiner");
    (0x200d, 0x200d, "a zero-width joiner");
    (0x200e, 0x200f, "a mark of direction");
    (0x202a, 0x202e, "a mark of direction");
    (0x2060, 0x2060, "a word joiner");
    (0x2061, 0x2064, "an invisible operator");
    (0x2066, 0x2069, "a mark of direction");
    (0x2065, 0x206f, unseen);
    (0x3164, 0x3164, unseen);
    (0xfe00, 0xfe0f, "a variation selector");
    (0xfeff, 0xfeff, "a byte-order mark");
    (0xffa0, 0xffa0, unseen);
    (0xfff9, 0xfffb, unseen);
    (0x1d173, 0x1d17a, unseen);
    (0xe0000, 0xe0fff, unseen);
  ]

let line_ends =
  [
    (0x85, 0x85, "a next-line character");
    (0x2028, 0x2028, "a line separator");
    (0x2029, 0x2029, "a paragraph separator");
  ]

let spaces =
  [
    (0xa0, 0xa0, "a no-break space");
    (0x1680, 0x1680, "an ogham space");
    (0x2000, 0x2001, "a quad");
    (0x2002, 0x2002, "an en space");
    (0x2003, 0x2003, "an em space");
    (0x2007, 0x2007, "a figure space");
    (0x2009, 0x2009, "a thin space");
    (0x200a, 0x200a, "a hair space");
    (0x2004, 0x2008, "a typographic space");
    (0x202f, 0x202f, "a narrow no-break space");
    (0x205f, 0x205f, "a mathematical space");
    (0x3000, 0x3000, "an ideographic space");
  ]

let others =
  [
    (0xab, 0xab, "a quotation mark", "\"");
    (0xb4, 0xb4, "an acute accent", "'");
    (0xbb, 0xbb, "a quotation mark", "\"");
    (0x60c, 0x60c, "an Arabic comma", ",");
    (0x66b, 0x66b, "an Arabic decimal separator", ".");
    (0x2010, 0x2010, "a typographic hyphen", "-");
    (0x2011, 0x2011, "a no-break hyphen", "-");
    (0x2012, 0x2012, "a figure dash", "-");
    (0x2013, 0x2013, "an en dash", "-");
    (0x2014, 0x2014, "an em dash", "-");
    (0x2015, 0x2015, "a bar", "-");
    (0x2018, 0x2019, "a quotation mark", "'");
    (0x201a, 0x201a, "a quotation mark", ",");
    (0x201b, 0x201b, "a quotation mark", "'");
    (0x201c, 0x201f, "a quotation mark", "\"");
    (0x2032, 0x2032, "a prime", "'");
    (0x2033, 0x2033, "a double prime", "\"");
    (0x2039, 0x203a, "a quotation mark", "'");
    (0x2212, 0x2212, "a minus sign", "-");
    (0xfe63, 0xfe63, "a small hyphen", "-");
  ]

(* Letters that look like those of a to z, the codes and what they look like. *)
let letters =
  let greek = "a Greek letter" and cyrillic = "a Cyrillic letter" in
  let letter name (code, meant) = (code, code, name, meant) in
  List.map (letter greek)
    [
      (0x391, "A"); (0x392, "B"); (0x395, "E"); (0x397, "H"); (0x399, "I");
      (0x39a, "K"); (0x39c, "M"); (0x39d, "N"); (0x39f, "O"); (0x3a1, "P");
      (0x3a4, "T"); (0x3a5, "Y"); (0x3a7, "X"); (0x3bd, "v"); (0x3bf, "o");
    ]
  @ List.map (letter cyrillic)
      [
        (0x405, "S"); (0x406, "I"); (0x408, "J"); (0x410, "A"); (0x412, "B");
        (0x415, "E"); (0x41a, "K"); (0x41c, "M"); (0x41d, "H"); (0x41e, "O");
        (0x420, "P"); (0x421, "C"); (0x422, "T"); (0x423, "Y"); (0x425, "X");
        (0x430, "a"); (0x435, "e"); (0x43e, "o"); (0x440, "p"); (0x441, "c");
        (0x443, "y"); (0x445, "x"); (0x455, "s"); (0x456, "i"); (0x458, "j");
        (0x4bb, "h"); (0x501, "d");
      ]
[@@ocamlformat "disable"]

(* {1 Looking one up} *)

let in_row code (first, last) = first <= code && code <= last

let table =
  let meaning meant (first, last, name) = (first, last, name, meant) in
  List.map (meaning "") unseen
  @ List.map (meaning " ") (line_ends @ spaces)
  @ others @ letters

(* The characters of ASCII, as wide as those of Chinese. *)
let full_width code =
  if in_row code (0xff01, 0xff5e) then
    let plain = String.make 1 (Char.chr (code - 0xff01 + Char.code '!')) in
    Some (Printf.sprintf "a full-width '%s'" plain, plain)
  else None

let strange code =
  let is_it (first, last, _, _) = in_row code (first, last) in
  if 0x20 <= code && code < 0x7f then None
  else
    match List.find_opt is_it table with
    | Some (_, _, name, meant) -> Some (name, meant)
    | None -> full_width code

let is_unseen =
  let rows = List.map (fun (first, last, _) -> (first, last)) in
  let rows = rows (unseen @ line_ends) in
  fun code ->
    (not (0x20 <= code && code < 0x7f)) && List.exists (in_row code) rows
