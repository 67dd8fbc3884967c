{
let mark = "\xef\xbb\xbf"

let without text =
  if String.starts_with ~prefix:mark text then
    let length = String.length mark in
    String.sub text length (String.length text - length)
  else text
}

rule skip = parse
  | "\xef\xbb\xbf" {
      (* the first column is after it *)
      let place = lexbuf.lex_curr_p in
      lexbuf.lex_curr_p <- { place with pos_bol = place.pos_cnum } }
  | "\xff\xfe" | "\xfe\xff" {
      Location.raise_errorf ~loc:(Location.curr lexbuf)
        "The text is UTF-16. Save it as UTF-8." }
  | "" { () }
