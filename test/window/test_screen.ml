open Raylab_window

let test_address () =
  let check text expected =
    let address =
      Option.map
        (fun { Screen.host; display } -> (host, display))
        (Screen.address text)
    in
    Alcotest.(check (option (pair string int))) text expected address
  in
  check ":0" (Some ("", 0));
  check ":12.3" (Some ("", 12));
  check "unix:1" (Some ("", 1));
  check "there:10.0" (Some ("there", 10));
  check "" None;
  check "there" None;
  check ":x" None

let entry ~number ~name secret =
  let field text =
    Printf.sprintf "\000%c%s" (Char.chr (String.length text)) text
  in
  "\001\000" ^ field "host" ^ field number ^ field name ^ field secret

let test_cookie () =
  let magic = "MIT-MAGIC-COOKIE-1" in
  let check name expected file =
    Alcotest.(check (option string))
      name expected
      (Screen.cookie ~display:3 file)
  in
  let other = entry ~number:"2" ~name:magic "two"
  and other_kind = entry ~number:"3" ~name:"SOMETHING" "else"
  and ours = entry ~number:"3" ~name:magic "three" in
  check "no file" None "";
  check "others" None (other ^ other_kind);
  check "ours" (Some "three") (other ^ other_kind ^ ours);
  check "for any display" (Some "any") (entry ~number:"" ~name:magic "any");
  check "cut off" None (String.sub ours 0 20)

(* vendor "abcde", one format, and then a screen of 1280 x 1024 *)
let test_reply () =
  let body = Bytes.make (32 + 8 + 8 + 40) '\000' in
  Bytes.set_uint16_le body 16 5;
  Bytes.set_uint8 body 21 1;
  Bytes.set_uint16_le body (32 + 8 + 8 + 20) 1280;
  Bytes.set_uint16_le body (32 + 8 + 8 + 22) 1024;
  let check name expected body =
    Alcotest.(check (option (pair int int)))
      name expected
      (Screen.size_in_reply body)
  in
  check "size" (Some (1280, 1024)) (Bytes.to_string body);
  check "cut off" None (Bytes.sub_string body 0 40);
  check "empty" None ""

let suite =
  ( "Screen",
    [
      Alcotest.test_case "address" `Quick test_address;
      Alcotest.test_case "cookie" `Quick test_cookie;
      Alcotest.test_case "reply" `Quick test_reply;
    ] )
