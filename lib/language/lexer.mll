{
(* {1 Names}

   A word that a definition, a loop or a parameter introduces is a name from
   there to the end of the block around it, whatever else it means. *)

module Names = Set.Make (String)

type after = Binder | Parameters | Included_name | Mesh_name | Other

type files = {
  include_ : Raylab_source.Span.t -> string -> Syntax.included;
  mesh : Raylab_source.Span.t -> string -> Raylab_mesh_file.Model.t;
}

let no_files =
  let open Raylab_mesh_file in
  { include_ = (fun _ _ -> Included.nothing); mesh = (fun _ _ -> Model.nothing) }

type state = {
  files : files;
  mutable blocks : Names.t list;  (* names of the blocks that are open *)
  mutable depth : int;  (* of the brackets that are open *)
  mutable after : after;
  mutable starts_parameter : bool;
  mutable after_else : bool;
  mutable operators : int list;  (* of the brackets that are open *)
  mutable too_deep : (int * string) option;
  mutable taken : (string * int) list;
}

let start ?(files = no_files) () =
  { files; blocks = [ Names.empty ]; depth = 0; after = Other;
    starts_parameter = false; after_else = false; operators = [];
    too_deep = None; taken = [] }

let too_deep state = state.too_deep
let taken state = List.rev state.taken
let key = String.lowercase_ascii

let is_name state word =
  match state.blocks with
  | [ names ] when Names.is_empty names -> false
  | blocks ->
      let key = key word in
      List.exists (Names.mem key) blocks

let names state =
  Names.elements (List.fold_left Names.union Names.empty state.blocks)

let add_names state names =
  match state.blocks with
  | [] -> state.blocks <- [ names ]
  | own :: rest -> state.blocks <- Names.union names own :: rest

let introduce state (lexbuf : Lexing.lexbuf) word =
  if Keyword.token word <> None && not (is_name state word) then
    state.taken <- (word, lexbuf.lex_start_p.pos_cnum) :: state.taken;
  add_names state (Names.singleton (key word))

let deepest = 1000

let check_depth state (lexbuf : Lexing.lexbuf) depth message =
  if depth > deepest && state.too_deep = None then
    state.too_deep <- Some (lexbuf.lex_start_p.pos_cnum, message)

let open_block state lexbuf =
  state.blocks <- Names.empty :: state.blocks;
  check_depth state lexbuf
    (List.length state.blocks - 1)
    "blocks are nested deeper than 1,000"

let close_block state =
  match state.blocks with
  | _ :: (_ :: _ as rest) -> state.blocks <- rest
  | _ -> ()

let open_bracket state lexbuf =
  state.depth <- state.depth + 1;
  state.operators <- 0 :: state.operators;
  check_depth state lexbuf state.depth "brackets are nested deeper than 1,000"

(* What an operator has on both sides may be deep, too. *)
let operator state lexbuf token =
  match state.operators with
  | count :: around ->
      state.operators <- (count + 1) :: around;
      check_depth state lexbuf (count + 1)
        "there are more than 1,000 operators in one expression";
      token
  | [] -> token

let next_element state =
  match state.operators with
  | _ :: around -> state.operators <- 0 :: around
  | [] -> ()

let close_bracket state =
  state.depth <- Int.max 0 (state.depth - 1);
  state.operators <-
    (match state.operators with _ :: around -> around | [] -> []);
  if state.depth = 0 then state.after <- Other

(* {1 Words outside of brackets} *)

let structural state lexbuf (token : Parser.token) =
  let after_else = state.after_else in
  state.after_else <- false;
  (match token with
  | LET | VARYING -> state.after <- Binder
  | INCLUDE -> state.after <- Included_name
  | MESH -> state.after <- Mesh_name
  | FOR -> open_block state lexbuf; state.after <- Binder
  | IF -> if not after_else then open_block state lexbuf
  | GROUP | UNION | INTERSECTION | DIFFERENCE -> open_block state lexbuf
  | ELSE ->
      close_block state;
      open_block state lexbuf;
      state.after_else <- true
  | END -> close_block state
  | _ -> ());
  token

let is_letter c =
  match c with 'a' .. 'z' | 'A' .. 'Z' | '_' -> true | _ -> false

let looks_like_name text =
  is_letter text.[0]
  && String.for_all (fun c -> is_letter c || ('0' <= c && c <= '9')) text

let word state lexbuf text =
  let is_bound = state.after = Binder in
  state.after <- Other;
  match Keyword.find text with
  | Some { role = Structure; token; _ } -> structural state lexbuf token
  | found -> (
      state.after_else <- false;
      if is_bound && looks_like_name text then (
        introduce state lexbuf text;
        Parser.NAME text)
      else if is_name state text then Parser.NAME text
      else
        match found with
        | Some { token; _ } -> structural state lexbuf token
        | None -> Parser.WORD text)

(* Of a word right before a bracket: whether it is called. *)
let is_called state text =
  let is_reserved =
    match Keyword.find text with
    | Some { role = Structure; _ } -> true
    | _ -> false
  in
  (not is_reserved) && (state.after = Binder || is_name state text)

let call state lexbuf text =
  if state.after = Binder then (
    introduce state lexbuf text;
    state.after <- Parameters;
    state.starts_parameter <- true);
  open_bracket state lexbuf;
  Parser.CALL text

(* A text in quotes; where it names a file that is included, the names of that
   are known from here. *)
let text state (lexbuf : Lexing.lexbuf) text =
  let span =
    { Raylab_source.Span.start = lexbuf.lex_start_p.pos_cnum;
      stop = lexbuf.lex_curr_p.pos_cnum }
  and after = state.after in
  state.after <- Other;
  match after with
  | Included_name ->
      let included = state.files.include_ span text in
      add_names state (Names.of_list included.names);
      Parser.FILE included
  | Mesh_name -> Parser.MODEL (state.files.mesh span text)
  | Binder | Parameters | Other -> Parser.STRING text

let number (lexbuf : Lexing.lexbuf) =
  Parser.NUMBER
    (Raylab_source.Decimal.of_bytes lexbuf.lex_buffer ~first:lexbuf.lex_start_pos
       ~stop:lexbuf.lex_curr_pos)

(* {1 Words in brackets} *)

let name_inside state lexbuf text =
  match Keyword.reserved_inside text with
  | Some token -> operator state lexbuf token
  | None ->
      if state.after = Parameters && state.depth = 1 && state.starts_parameter
      then introduce state lexbuf text;
      state.starts_parameter <- false;
      Parser.NAME text

(* Shortens what was read by its last byte, which is read again. *)
let without_last (lexbuf : Lexing.lexbuf) =
  lexbuf.lex_curr_pos <- lexbuf.lex_curr_pos - 1;
  lexbuf.lex_curr_p <-
    { lexbuf.lex_curr_p with pos_cnum = lexbuf.lex_curr_p.pos_cnum - 1 }
}

let blank = [' ' '\t' '\n' '\r' '\011' '\012']
let digits = ['0'-'9']+
let unsigned =
  (digits ('.' ['0'-'9']*)? | '.' digits) (['e' 'E'] ['+' '-']? digits)?
let name = ['a'-'z' 'A'-'Z' '_'] ['a'-'z' 'A'-'Z' '_' '0'-'9']*

rule item state = parse
  | blank+ | '#' [^ '\n' '\r']* { item state lexbuf }
  | ['+' '-']? unsigned { number lexbuf }
  | (name as text) '('
      { if is_called state text then call state lexbuf text
        else (without_last lexbuf; word state lexbuf text) }
  | '(' { open_bracket state lexbuf; LPAREN }
  | '[' { open_bracket state lexbuf; LBRACKET }
  | ')' { RPAREN }
  | ']' { RBRACKET }
  | '=' { EQUAL }
  | '"' ([^ '"' '\n' '\r']* as content) '"' { text state lexbuf content }
  | [^ ' ' '\t' '\r' '\011' '\012' '\n' '#' '(' ')' '[' ']' '=']+ as text
      { word state lexbuf text }
  | eof { EOF }

and expression state = parse
  | blank+ | '#' [^ '\n' '\r']* { expression state lexbuf }
  | unsigned { number lexbuf }
  | (name as text) '('
      { if Keyword.reserved_inside text = None then call state lexbuf text
        else (without_last lexbuf; name_inside state lexbuf text) }
  | name as text { name_inside state lexbuf text }
  | '.' (['x' 'y' 'z' 'r' 'g' 'b' 'X' 'Y' 'Z' 'R' 'G' 'B'] as letter)
      { operator state lexbuf (Parser.PART (Char.lowercase_ascii letter)) }
  | '.' name as text { WORD text }
  | '(' { open_bracket state lexbuf; LPAREN }
  | '[' { open_bracket state lexbuf; LBRACKET }
  | ')' { close_bracket state; RPAREN }
  | ']' { close_bracket state; RBRACKET }
  | ','
      { next_element state; state.starts_parameter <- true; COMMA }
  | ':' { state.starts_parameter <- false; COLON }
  | '+' { operator state lexbuf Parser.PLUS }
  | '-' { operator state lexbuf Parser.MINUS }
  | '*' { operator state lexbuf Parser.TIMES }
  | '/' { operator state lexbuf Parser.DIVIDE }
  | '^' { operator state lexbuf Parser.POWER }
  | '=' { operator state lexbuf Parser.EQUAL }
  | "<>" { operator state lexbuf Parser.DIFFERENT }
  | "<=" { operator state lexbuf Parser.LESS_EQUAL }
  | '<' { operator state lexbuf Parser.LESS }
  | ">=" { operator state lexbuf Parser.GREATER_EQUAL }
  | '>' { operator state lexbuf Parser.GREATER }
  | "==" | "!=" as text { WORD text }
  | '"' ([^ '"' '\n' '\r']* as text) '"' { STRING text }
  | [^ ' ' '\t' '\r' '\011' '\012' '\n' '#' '(' ')' '[' ']' ',' ':' '+' '*' '/'
     '^' '=' '<' '>' '"' '-' '.' '0'-'9' 'a'-'z' 'A'-'Z' '_']+ as text
      { WORD text }
  | _ as c { WORD (String.make 1 c) }
  | eof { EOF }

{
let is_blank = function
  | ' ' | '\t' | '\n' | '\r' | '\011' | '\012' -> true
  | _ -> false

let rec after_blanks (lexbuf : Lexing.lexbuf) at =
  if at < lexbuf.lex_buffer_len && is_blank (Bytes.get lexbuf.lex_buffer at)
  then after_blanks lexbuf (at + 1)
  else at

(* Skips those blanks that are in the buffer already. The rules would do it, but
   then half of all that they match would be blanks. *)
let skip_blanks (lexbuf : Lexing.lexbuf) =
  let at = after_blanks lexbuf lexbuf.lex_curr_pos in
  if at > lexbuf.lex_curr_pos then (
    lexbuf.lex_curr_pos <- at;
    lexbuf.lex_curr_p <-
      { lexbuf.lex_curr_p with pos_cnum = lexbuf.lex_abs_pos + at })

let token state lexbuf =
  skip_blanks lexbuf;
  if state.too_deep <> None then Parser.EOF
  else if state.depth > 0 then expression state lexbuf
  else item state lexbuf
}
