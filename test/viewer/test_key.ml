open Raylab_viewer

let test_keys () =
  let keys =
    List.filter (fun c -> Key.of_char c <> None) (List.init 256 Char.chr)
  in
  Alcotest.(check (list char))
    "these and no others"
    (List.of_seq (String.to_seq "\027+-0=CEHQRSVcehqrsv"))
    keys;
  List.iter
    (fun c ->
      Alcotest.(check bool)
        "the same with Caps Lock" true
        (Key.of_char c = Key.of_char (Char.uppercase_ascii c)))
    keys;
  let is_listed c =
    List.exists (fun line -> line.[0] = c) (String.split_on_char '\n' Key.help)
  in
  Alcotest.(check bool)
    "listed" true
    (List.for_all is_listed [ '+'; '0'; 'v'; 'c'; 'e'; 'h'; 'q'; 'r'; 's' ])

let suite = ("Key", [ Alcotest.test_case "keys" `Quick test_keys ])
