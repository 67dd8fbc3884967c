open Raylab_scene
open Test_support

let check = Alcotest.check Same.number

let test_arithmetic () =
  check "add" 0.75 (Grey.add 0.5 0.25);
  check "scale" 1.5 (Grey.scale 3. 0.5);
  check "multiply" 0.125 (Grey.multiply 0.5 0.25);
  check "black" 0. Grey.black;
  check "white" 1. Grey.white;
  Alcotest.check (Same.near 1e-15) "of_color" 0.7152
    (Grey.of_color Color.green);
  Alcotest.check Same.levels "to_bytes" (128, 128, 128) (Grey.to_bytes 0.5);
  Expect.prints "pp" "grey 0.5" Grey.pp 0.5

(* Greys are a smaller world inside the colours: to compute there and then to
   look at it as a colour is the same, to the last bit, as to compute with
   colours. The tracer needs no second version for greyscale because of it. *)
let commutes name grey color =
  Property.holds name
    QCheck2.Gen.(
      pair
        (Generate.at_least_0 Generate.extreme)
        (Generate.at_least_0 Generate.extreme))
    (fun (a, b) ->
      Color.equal
        (Grey.to_color (grey a b))
        (color a (Grey.to_color a) (Grey.to_color b)))

let bytes_agree =
  Property.holds "to_bytes is that of the colour" Generate.extreme (fun g ->
      Grey.to_bytes g = Color.to_bytes (Grey.to_color g))

(* Up to rounding, since the three factors add up to 1. *)
let luminance_of_a_grey =
  Property.holds "the luminance of a grey is the grey"
    (Generate.at_least_0 Generate.everyday) (fun g ->
      abs_float (Grey.of_color (Grey.to_color g) -. g) <= 1e-15 *. (g +. 1.))

let suite =
  ( "Grey",
    [
      Alcotest.test_case "arithmetic" `Quick test_arithmetic;
      commutes "add commutes with to_color" Grey.add (fun _ a b ->
          Color.add a b);
      commutes "scale commutes with to_color" Grey.scale (fun k _ b ->
          Color.scale k b);
      commutes "multiply commutes with to_color" Grey.multiply (fun _ a b ->
          Color.multiply a b);
      bytes_agree;
      luminance_of_a_grey;
    ] )
