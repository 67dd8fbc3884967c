open Raylab_source
module Engine = Slow_parser.MenhirInterpreter

(* Feeding the text in pieces spares a second copy of a large one. *)
let lexbuf { Sources.text; base; _ } =
  let next = ref 0 in
  let feed buffer wanted =
    let length = Int.min wanted (String.length text - !next) in
    Bytes.blit_string text !next buffer 0 length;
    next := !next + length;
    length
  in
  let lexbuf = Lexing.from_function feed in
  Lexing.set_position lexbuf { Lexing.dummy_pos with pos_cnum = base };
  lexbuf

(* What programs in other languages write. *)
let special (token : Parser.token) =
  match token with
  | WORD "==" -> Some ("'==' is no operator", "two values are compared by =")
  | WORD "!=" ->
      Some ("'!=' is no operator", "that two values differ is written <>")
  | _ -> None

let own_definition sources span =
  let word = Sources.quote sources span in
  Scene_error.make sources span
    (Printf.sprintf "'%s' stands in its own definition" word)
    ~advice:
      (Printf.sprintf
         "after let it is a name, and no longer the word of the language: \
          choose\n\
          another name, such as my_%s"
         word)

let syntax_error sources checkpoint state names token (start : Lexing.position)
    (stop : Lexing.position) =
  let span = { Span.start = start.pos_cnum; stop = stop.pos_cnum } in
  let acceptable token = Engine.acceptable checkpoint token start in
  let { Expectation.noun = expected; advice } = Expectation.of_state state in
  let habit =
    let text = Sources.slice sources span in
    Option.fold ~none:"" ~some:(( ^ ) "\n")
      (Habit.advice ~acceptable ~expected ~text token)
  in
  let article =
    match expected.[0] with
    | 'a' | 'e' | 'i' | 'o' | 'u' -> "an "
    | '\'' -> ""
    | _ -> "a "
  in
  match (special token, (token : Parser.token)) with
  | Some (message, advice), _ -> Scene_error.make sources span message ~advice
  | None, WORD _ ->
      Unknown_word.error sources span ~acceptable ~names ~expected ~advice
        ~habit
  | None, EOF ->
      Scene_error.make sources span ~advice
        (Printf.sprintf "the file ends where %s%s should follow" article
           expected)
  | None, _ ->
      Scene_error.make sources span ~advice:(advice ^ habit)
        (Printf.sprintf "%s%s should stand here, not '%s'" article expected
           (Sources.quote sources span))

(* Runs the slow parser over a text that the fast one refused. *)
let explain_error sources files file =
  let lexbuf = lexbuf file and words = Lexer.start ?files () in
  let rec run input checkpoint =
    match checkpoint with
    | Engine.InputNeeded _ ->
        let token = Lexer.token words lexbuf in
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
        let names = Lexer.names words in
        let used =
          Taken.used_in_definition sources ~before:start.pos_cnum
            (Lexer.taken words)
        in
        Error
          (match used with
          | Some span -> own_definition sources span
          | None -> syntax_error sources before state names token start stop)
    | Rejected -> assert false (* comes only after [HandlingError] *)
    | Accepted syntax -> Ok syntax
  in
  let start = Slow_parser.Incremental.scene Lexing.dummy_pos in
  run (start, Parser.EOF, Lexing.dummy_pos, Lexing.dummy_pos) start

let too_deep sources (offset, message) =
  Scene_error.make sources { start = offset; stop = offset + 1 } message

type parsed = { included : Syntax.included; taken : Taken.t list }

let parse ?files sources file =
  let words = Lexer.start ?files () in
  let result =
    match Parser.scene (Lexer.token words) (lexbuf file) with
    | syntax -> Ok syntax
    | exception Parser.Error -> explain_error sources files file
  in
  match Lexer.too_deep words with
  | Some found -> Error (too_deep sources found)
  | None ->
      let read syntax =
        let names = Lexer.names words and taken = Lexer.taken words in
        { included = { base = file.base; names; syntax }; taken }
      in
      Result.map read result
