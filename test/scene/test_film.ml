open Raylab_scene
open Test_support
open Build

let close = Same.near 1e-12

let test_default () =
  Alcotest.(check bool) "itself" true (Film.equal Film.default (Film.make ()));
  let c = rgb 0.25 1. 0. in
  Alcotest.check Same.color "shown as it is" c
    (Film.encode Film.default (Film.expose Film.default c))

let test_invalid () =
  List.iter
    (fun samples -> Expect.invalid "samples" (fun () -> Film.make ~samples ()))
    [ 0; -1; Film.max_samples + 1 ];
  List.iter
    (fun exposure ->
      Expect.invalid "exposure" (fun () -> Film.make ~exposure ()))
    [ 0.; -1.; nan; infinity ];
  Expect.invalid "aperture" (fun () -> Lens.make (-1.));
  Expect.invalid "focus" (fun () -> Lens.make ~focus:0. 1.)

let test_expose () =
  let film = Film.make ~exposure:2. () in
  let check what expected c =
    Alcotest.check Same.color what expected (Film.expose film c)
  in
  check "twice" (rgb 0.5 1. 0.) (rgb 0.25 0.5 0.);
  check "at most 1" (rgb 1. 1. 0.2) (rgb 7. max_float 0.1);
  let over what expected c =
    Alcotest.(check bool) what expected (Film.over_exposed film c)
  in
  over "1 is not over-exposed" false (rgb 0.5 0.5 0.5);
  over "nor what is rounded to 255" false (rgb 0. 0.5009 0.);
  over "a level more is" true (rgb 0. 0.51 0.)

(* From the table of IEC 61966-2-1: 8 bits, there and back. *)
let test_srgb () =
  let check expected v =
    Alcotest.check close (string_of_float v) expected (Srgb.encode v)
  in
  check 0. 0.;
  check 1. 1.;
  check 0.040449936 0.0031308;
  check 0.7353569830524495 0.5;
  check 0.4613561295004 0.18;
  let film = Film.make ~srgb:true () in
  Alcotest.check Same.levels "bytes" (0, 188, 255)
    (Film.to_bytes film (rgb 0. 0.5 1.))

let rises =
  Property.holds "more light is shown as more"
    QCheck2.Gen.(pair (float_bound_inclusive 1.) (float_bound_inclusive 1.))
    (fun (a, b) ->
      let a = Float.min a b and b = Float.max a b in
      Srgb.encode a <= Srgb.encode b +. 1e-7 && 0. <= Srgb.encode a)

let suite =
  ( "Film",
    [
      Alcotest.test_case "default" `Quick test_default;
      Alcotest.test_case "invalid" `Quick test_invalid;
      Alcotest.test_case "exposure" `Quick test_expose;
      Alcotest.test_case "sRGB" `Quick test_srgb;
      rises;
    ] )
