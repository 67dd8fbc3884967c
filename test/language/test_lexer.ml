open Raylab_language

let show (token : Parser.token) =
  match token with
  | NUMBER x -> Printf.sprintf "%g" x
  | COLOR c -> Format.asprintf "%a" Raylab_scene.Color.pp c
  | WORD w -> Printf.sprintf "<%s>" w
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

let suite =
  ( "Lexer",
    [
      Alcotest.test_case "numbers" `Quick test_numbers;
      Alcotest.test_case "malformed numbers" `Quick test_malformed;
      Alcotest.test_case "separators" `Quick test_separators;
      Alcotest.test_case "comments" `Quick test_comments;
      Alcotest.test_case "words" `Quick test_words;
      Alcotest.test_case "any bytes" `Quick test_bytes;
    ] )
