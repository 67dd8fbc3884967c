{
let word text =
  match Keyword.token text with
  | Some token -> token
  | None -> Parser.WORD text
}

let blank = [' ' '\t' '\r' '\011' '\012']
let digits = ['0'-'9']+
let number =
  ['+' '-']? (digits ('.' ['0'-'9']*)? | '.' digits) (['e' 'E'] ['+' '-']? digits)?

rule token = parse
  | blank+ | '#' [^ '\n']* { token lexbuf }
  | '\n' { Lexing.new_line lexbuf; token lexbuf }
  | number as text { Parser.NUMBER (float_of_string text) }
  | [^ ' ' '\t' '\r' '\011' '\012' '\n' '#']+ as text { word text }
  | eof { Parser.EOF }
