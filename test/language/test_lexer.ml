open Raylab_language

let show (token : Parser.token) =
  match token with
  | NUMBER x -> Printf.sprintf "%g" x
  | COLOR c -> Format.asprintf "%a" Raylab_scene.Color.pp c
  | WORD w -> Printf.sprintf "<%s>" w
  | NAME n -> "name " ^ n
  | CALL n -> Printf.sprintf "call %s(" n
  | STRING s -> Printf.sprintf "%S" s
  | PART c -> Printf.sprintf ".%c" c
  | LPAREN -> "("
  | RPAREN -> ")"
  | LBRACKET -> "["
  | RBRACKET -> "]"
  | COMMA -> ","
  | COLON -> ":"
  | PLUS -> "+"
  | MINUS -> "-"
  | TIMES -> "*"
  | DIVIDE -> "/"
  | POWER -> "^"
  | EQUAL -> "="
  | DIFFERENT -> "<>"
  | LESS -> "<"
  | LESS_EQUAL -> "<="
  | GREATER -> ">"
  | GREATER_EQUAL -> ">="
  | THEN -> "then"
  | AND -> "and"
  | OR -> "or"
  | NOT -> "not"
  | TRUE -> "true"
  | FALSE -> "false"
  | EOF -> "end"
  | keyword -> (
      match List.find_opt (fun (_, t) -> t = keyword) Keyword.all with
      | Some (name, _) -> name
      | None -> "?")

let tokens text =
  let lexbuf = Lexing.from_string text and words = Lexer.start () in
  let rec read () =
    match Lexer.token words lexbuf with
    | Parser.EOF -> []
    | token ->
        let word = show token in
        word :: read ()
  in
  read ()

let check text expected =
  Alcotest.(check (list string)) (String.escaped text) expected (tokens text)

let test_numbers () =
  let check text expected =
    match Lexer.token (Lexer.start ()) (Lexing.from_string text) with
    | NUMBER x -> Alcotest.check Test_support.Same.number text expected x
    | token -> Alcotest.failf "%s is %s" text (show token)
  in
  check "1" 1.;
  check "1." 1.;
  check ".5" 0.5;
  check "-0.25" (-0.25);
  check "+3" 3.;
  check "2e-3" 0.002;
  check "2E3" 2000.;
  check "-1.5e+2" (-150.);
  check "+.5e1" 5.;
  check "1.e1" 10.;
  check "007" 7.;
  check "-0" (-0.);
  check "1e999" infinity;
  check "1e-999" 0.;
  check "5e-324" 5e-324;
  check "0.1" 0.1

(* Whatever looks like a number but is none is one word, not a number and a
   rest. *)
let test_malformed () =
  List.iter
    (fun text -> check text [ "<" ^ text ^ ">" ])
    [
      "1.2.3"; "12abc"; "."; "-"; "+"; "--1"; "+-1"; "1e"; "1e+"; "e5"; "1-2";
      "0x10"; "1_000"; "1,5"; "nan"; "inf"; "-infinity"; "1e5.5"; ".e5"; "1f";
      "\xc2\xbd"; "\xd9\xa3";
    ] [@ocamlformat "disable"]

let test_separators () =
  check "1 2\t3\r\n4\n5\x0b6\x0c7" [ "1"; "2"; "3"; "4"; "5"; "6"; "7" ];
  check "" [];
  check " \n\t\r\n" []

let test_comments () =
  check "# all" [];
  check "1 # 2\n3" [ "1"; "3" ];
  check "1#2\r\n3" [ "1"; "3" ];
  check "sphere# plane" [ "sphere" ];
  check "#\n##\n1" [ "1" ];
  check "1 # no line end" [ "1" ];
  check "1 # 2\r3" [ "1"; "3" ];
  check "#\r1" [ "1" ]

let test_words () =
  check "SPHERE Sphere sPhErE" [ "sphere"; "sphere"; "sphere" ];
  check "imwidth IMWIDTH" [ "imWidth"; "imWidth" ];
  (* both names are one keyword *)
  check "bgcolor bcolor" [ "bcolor"; "bcolor" ];
  check "Red YELLOW" [ "rgb 1 0 0"; "rgb 1 1 0" ];
  check "spheres sphere1" [ "<spheres>"; "<sphere1>" ]

let test_bytes () =
  check "\x00" [ "<\x00>" ];
  check "a\x00b c" [ "<a\x00b>"; "<c>" ];
  check "\xff\xfe" [ "<\xff\xfe>" ];
  check "\xc3\xa9" [ "<\xc3\xa9>" ];
  check "\xef\xbb\xbf1" [ "<\xef\xbb\xbf1>" ]

(* {1 In brackets} *)

let test_operators () =
  check "(1-2)" [ "("; "1"; "-"; "2"; ")" ];
  check "-1 (-1) -1" [ "-1"; "("; "-"; "1"; ")"; "-1" ];
  check "(a<=b<>c<d>=e>f)"
    [ "("; "name a"; "<="; "name b"; "<>"; "name c"; "<"; "name d"; ">=";
      "name e"; ">"; "name f"; ")" ];
  check "(1e3+.5^2/x*3)"
    [ "("; "1000"; "+"; "0.5"; "^"; "2"; "/"; "name x"; "*"; "3"; ")" ];
  check "(a == b != c)"
    [ "("; "name a"; "<==>"; "name b"; "<!=>"; "name c"; ")" ];
  check "(v.X v.g f(1).z v.w)"
    [ "("; "name v"; ".x"; "name v"; ".g"; "call f("; "1"; ")"; ".z"; "name v";
      "<.w>"; ")" ];
  check "[1,2]" [ "["; "1"; ","; "2"; "]" ];
  check "(1 ! 2)" [ "("; "1"; "<!>"; "2"; ")" ];
  check "(\"a # b\" \"c" [ "("; "\"a # b\""; "<\">"; "name c" ]
[@@ocamlformat "disable"]

(* Inside, only what is reserved is a word. *)
let test_words_inside () =
  check "sphere (sphere) red (red)"
    [ "sphere"; "("; "name sphere"; ")"; "rgb 1 0 0"; "("; "name red"; ")" ];
  check "(if a THEN b else c)"
    [ "("; "if"; "name a"; "then"; "name b"; "else"; "name c"; ")" ];
  check "and (and or not true)" [ "<and>"; "("; "and"; "or"; "not"; "true"; ")" ];
  check "if(1)" [ "if"; "("; "1"; ")" ];
  check "(if(1))" [ "("; "if"; "("; "1"; ")"; ")" ]
[@@ocamlformat "disable"]

let test_modes () =
  check "(1-2) 1-2" [ "("; "1"; "-"; "2"; ")"; "<1-2>" ];
  check "((1)-2)" [ "("; "("; "1"; ")"; "-"; "2"; ")" ];
  check "[(1)-2]-2" [ "["; "("; "1"; ")"; "-"; "2"; "]"; "-2" ];
  check ") -1" [ ")"; "-1" ];
  check "(1 # )\n-2)" [ "("; "1"; "-"; "2"; ")" ];
  check "(1\r\n-2)" [ "("; "1"; "-"; "2"; ")" ]

(* A word that is introduced is a name until the end of its block. *)
let test_names () =
  check "let red = 1 red" [ "let"; "name red"; "="; "1"; "name red" ];
  check "red let red = 1" [ "rgb 1 0 0"; "let"; "name red"; "="; "1" ];
  check "group let red = 1 RED end red"
    [ "group"; "let"; "name red"; "="; "1"; "name RED"; "end"; "rgb 1 0 0" ];
  check "let f(sphere, plane: 2) = sphere plane"
    [ "let"; "call f("; "name sphere"; ","; "name plane"; ":"; "2"; ")"; "=";
      "name sphere"; "name plane" ];
  check "let f(a) = f(1) f (1)"
    [ "let"; "call f("; "name a"; ")"; "="; "call f("; "1"; ")"; "name f"; "(";
      "1"; ")" ];
  check "sphere(1)" [ "sphere"; "("; "1"; ")" ];
  check "let end" [ "let"; "end" ]
[@@ocamlformat "disable"]

let test_depth () =
  let deep word n =
    let lexbuf = Lexing.from_string (String.concat " " (List.init n word)) in
    let words = Lexer.start () in
    let rec read () = if Lexer.token words lexbuf <> Parser.EOF then read () in
    read ();
    Lexer.too_deep words <> None
  in
  let check what expected found = Alcotest.(check bool) what expected found in
  List.iter
    (fun word ->
      check word false (deep (fun _ -> word) 1000);
      check word true (deep (fun _ -> word) 1001))
    [ "("; "["; "group"; "if"; "for" ];
  let sum = function 0 -> "(" | _ -> "+" in
  check "operators" false (deep sum 1001);
  check "operators" true (deep sum 1002)

let suite =
  ( "Lexer",
    [
      Alcotest.test_case "numbers" `Quick test_numbers;
      Alcotest.test_case "malformed numbers" `Quick test_malformed;
      Alcotest.test_case "separators" `Quick test_separators;
      Alcotest.test_case "comments" `Quick test_comments;
      Alcotest.test_case "words" `Quick test_words;
      Alcotest.test_case "any bytes" `Quick test_bytes;
      Alcotest.test_case "operators" `Quick test_operators;
      Alcotest.test_case "words in brackets" `Quick test_words_inside;
      Alcotest.test_case "in and out of brackets" `Quick test_modes;
      Alcotest.test_case "names" `Quick test_names;
      Alcotest.test_case "depth" `Quick test_depth;
    ] )
