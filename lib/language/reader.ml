module Engine = Slow_parser.MenhirInterpreter

(* Feeding the text in pieces spares a second copy of a large one. *)
let lexbuf source =
  let text = Source.text source and next = ref 0 in
  Lexing.from_function (fun buffer wanted ->
      let length = Int.min wanted (String.length text - !next) in
      Bytes.blit_string text !next buffer 0 length;
      next := !next + length;
      length)

(* What was expected in a state, and the rest of what is said there. *)
let expectation state =
  let text = Parser_messages.message state in
  match String.index_opt text '\n' with
  | Some i ->
      ( String.sub text 0 i,
        String.trim (String.sub text i (String.length text - i)) )
  | None -> (text, "")

let syntax_error source checkpoint state token (start : Lexing.position)
    (stop : Lexing.position) =
  let span = Span.make ~start:start.pos_cnum ~stop:stop.pos_cnum in
  let expected, advice = expectation state in
  match (token : Parser.token) with
  | WORD _ ->
      let acceptable token = Engine.acceptable checkpoint token start in
      Unknown_word.error source span ~acceptable ~expected ~advice
  | EOF ->
      Scene_error.make source span ~advice
        (Printf.sprintf "the file ends where a %s should follow" expected)
  | _ ->
      Scene_error.make source span ~advice
        (Printf.sprintf "a %s should stand here, not '%s'" expected
           (Source.quote source span))

(* Runs the slow parser over a text that the fast one refused. *)
let explain_error source =
  let lexbuf = lexbuf source in
  let rec run input checkpoint =
    match checkpoint with
    | Engine.InputNeeded _ ->
        let token = Lexer.token lexbuf in
        let start = lexbuf.lex_start_p and stop = lexbuf.lex_curr_p in
        advance
          (checkpoint, token, start, stop)
          (Engine.offer checkpoint (token, start, stop))
    | _ -> advance input checkpoint
  and advance input checkpoint =
    match checkpoint with
    | Engine.InputNeeded _ -> run input checkpoint
    | Shifting _ | AboutToReduce _ -> advance input (Engine.resume checkpoint)
    | HandlingError env ->
        (* messages are numbered by the state after all reductions *)
        let before, token, start, stop = input in
        let state = Engine.current_state_number env in
        Error (syntax_error source before state token start stop)
    | Rejected -> assert false (* comes only after [HandlingError] *)
    | Accepted syntax -> Ok syntax
  in
  let start = Slow_parser.Incremental.scene Lexing.dummy_pos in
  run (start, Parser.EOF, Lexing.dummy_pos, Lexing.dummy_pos) start

let parse source =
  match Parser.scene Lexer.token (lexbuf source) with
  | syntax -> Ok syntax
  | exception Parser.Error -> explain_error source
