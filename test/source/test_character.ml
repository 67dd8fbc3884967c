open Raylab_source

let test_unseen () =
  let check what expected code =
    Alcotest.(check bool) what expected (Character.is_unseen code)
  in
  check "a letter" false (Char.code 'a');
  check "a space" false 0x20;
  check "a no-break space" false 0xa0;
  check "a minus sign" false 0x2212;
  check "a control character" true 0x1b;
  check "a soft hyphen" true 0xad;
  check "a line separator" true 0x2028;
  check "text reversed" true 0x202e;
  check "a byte-order mark" true 0xfeff

let suite = ("Character", [ Alcotest.test_case "unseen" `Quick test_unseen ])
