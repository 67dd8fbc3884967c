{
let number (lexbuf : Lexing.lexbuf) =
  Parser.NUMBER
    (Decimal.of_bytes lexbuf.lex_buffer ~first:lexbuf.lex_start_pos
       ~stop:lexbuf.lex_curr_pos)

let word text =
  match Keyword.token text with
  | Some token -> token
  | None -> Parser.WORD text
}

let blank = [' ' '\t' '\011' '\012']
let line_end = '\n' | '\r' | "\r\n"
let digits = ['0'-'9']+
let number =
  ['+' '-']? (digits ('.' ['0'-'9']*)? | '.' digits)
  (['e' 'E'] ['+' '-']? digits)?

rule token = parse
  | blank+ | '#' [^ '\n' '\r']* { token lexbuf }
  | line_end { Lexing.new_line lexbuf; token lexbuf }
  | number { number lexbuf }
  | [^ ' ' '\t' '\r' '\011' '\012' '\n' '#']+ as text { word text }
  | eof { Parser.EOF }
