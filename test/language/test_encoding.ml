open Raylab_language

let check text expected =
  Alcotest.(check (option string))
    (String.escaped text) expected (Encoding.foreign text)

let test_marks () =
  check "\xff\xfei\x00" (Some "UTF-16");
  check "\xfe\xff\x00i" (Some "UTF-16");
  check "\xff\xfe\x00\x00i\x00\x00\x00" (Some "UTF-32");
  check "\x00\x00\xfe\xff\x00\x00\x00i" (Some "UTF-32")

let test_letters () =
  check "i\x00m\x00" (Some "UTF-16");
  check "\x00i\x00m" (Some "UTF-16");
  check "i\x00\x00\x00" (Some "UTF-32");
  check "\x00\x00\x00i" (Some "UTF-32")

let test_ours () =
  List.iter
    (fun text -> check text None)
    [ ""; "i"; "imWidth"; "\xef\xbb\xbfimWidth"; "\x00\x00\x00\x00"; "\xff" ]

(* What is a scene as UTF-8 is one, whatever it looks like. *)
let test_valid () =
  let text = Read.with_header "sphere 0 0 6 1 reflective" in
  ignore (Read.scene ("#\x00a\x00\n" ^ text))

let suite =
  ( "Encoding",
    [
      Alcotest.test_case "marks" `Quick test_marks;
      Alcotest.test_case "letters" `Quick test_letters;
      Alcotest.test_case "ours" `Quick test_ours;
      Alcotest.test_case "a valid scene" `Quick test_valid;
    ] )
