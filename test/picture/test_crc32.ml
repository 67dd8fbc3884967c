open Raylab_picture

let check what hex text =
  Alcotest.(check string) what hex (Crc32.to_hex (Crc32.add Crc32.empty text))

(* The check value of the catalogues of checksums, and what ends every PNG. *)
let test_known () =
  check "nothing" "00000000" "";
  check "digits" "cbf43926" "123456789";
  check "IEND" "ae426082" "IEND"

let test_parts () =
  let crc = Crc32.add (Crc32.add Crc32.empty "1234") "56789" in
  Alcotest.(check string) "in two parts" "cbf43926" (Crc32.to_hex crc);
  let crc = Crc32.add_bytes Crc32.empty (Bytes.of_string "123456789") in
  Alcotest.(check string) "of bytes" "cbf43926" (Crc32.to_hex crc)

let suite =
  ( "CRC-32",
    [
      Alcotest.test_case "known ones" `Quick test_known;
      Alcotest.test_case "part by part" `Quick test_parts;
    ] )
