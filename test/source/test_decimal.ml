(* Decimal against the standard library's float_of_string. *)

open Raylab_source

let read text =
  let padded = Bytes.of_string ("##" ^ text ^ "##") in
  Decimal.of_bytes padded ~first:2 ~stop:(2 + String.length text)

let same text =
  Int64.(equal (bits_of_float (read text)))
    (Int64.bits_of_float (float_of_string text))

let check text = Alcotest.(check bool) text true (same text)

(* The edges of the fast way: 9 and 10 digits, 15 and 16, 22 and 23 decimals,
   leading zeros, which count for nothing, and both zeros. 2^32 and 2^31 + 1 are
   other numbers in 32 bits. *)
let test_edges () =
  List.iter check
    [
      "0";
      "-0";
      "+0";
      "-.5";
      "1.";
      "+3";
      "2e-3";
      "0.1";
      "-0.25";
      "999999999";
      "9999999999";
      "0.999999999";
      "1.0000000000";
      "2147483649";
      "4294967296";
      "42.949672960";
      "429496729600000";
      "0.123456789012";
      "999999999999999";
      "9999999999999999";
      "0.999999999999999";
      "9007199254740993";
      "000000000000000000000001.5";
      "0.0000000000000000000001";
      "0.00000000000000000000001";
      "123456789.123456789";
      "1e400";
      "1e-400";
      "4.9e-324";
      "0.30000000000000004";
      "179769313486231570000000000000000";
    ]

let decimals =
  let open QCheck2.Gen in
  let digits = string_size ~gen:numeral (1 -- 20) in
  let sign = oneofl [ ""; "-"; "+" ] in
  oneof
    [
      map2 ( ^ ) sign digits;
      map3 (fun sign a b -> sign ^ a ^ "." ^ b) sign digits digits;
      map2 (fun sign b -> sign ^ "." ^ b) sign digits;
      map3
        (fun a b e -> Printf.sprintf "%s.%se%d" a b e)
        digits digits (-330 -- 330);
      map (Printf.sprintf "%.17g") (float_bound_inclusive 1000.);
    ]

let suite =
  ( "Decimal",
    [
      Alcotest.test_case "edges" `Quick test_edges;
      Test_support.Property.holds "is float_of_string, bit for bit"
        ~count:20_000 ~print:Fun.id decimals same;
    ] )
