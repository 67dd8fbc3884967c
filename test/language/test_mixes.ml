(* A weight and its surface belong to the innermost mix that is open. *)

open Raylab_scene
open Test_support

let glow = Surface.luminous Color.red
let matt = Surface.diffusive Color.white
let mirror = Surface.reflective

let surfaces text =
  let scene = Read.scene (Read.with_header text) in
  List.map (fun (o : Object.t) -> o.surface) scene.objects

let check what text expected =
  Alcotest.(check (list Same.surface))
    what [ expected ]
    (surfaces ("sphere 0 0 6 1 " ^ text))

let test_flat () =
  check "one part" "mixed 2 reflective" (Surface.mixed [ (2., mirror) ]);
  check "three parts" "mixed 1 reflective .5 luminous red 3 diffusive white"
    (Surface.mixed [ (1., mirror); (0.5, glow); (3., matt) ]);
  (* a colour takes three numbers, the fourth is the next weight *)
  check "numbers" "mixed 1 luminous 1 0 0 .5 diffusive 1 1 1"
    (Surface.mixed [ (1., glow); (0.5, matt) ])

let test_innermost () =
  check "all that follows" "mixed 1 mixed 2 reflective 3 luminous red"
    (Surface.mixed [ (1., Surface.mixed [ (2., mirror); (3., glow) ]) ]);
  check "what stands before does not"
    "mixed 4 diffusive white 1 mixed 2 reflective 3 luminous red"
    (Surface.mixed
       [ (4., matt); (1., Surface.mixed [ (2., mirror); (3., glow) ]) ]);
  check "three deep"
    "mixed 1 reflective 2 mixed 3 reflective 4 mixed 5 reflective 6 luminous \
     red"
    (Surface.mixed
       [
         (1., mirror);
         ( 2.,
           Surface.mixed
             [ (3., mirror); (4., Surface.mixed [ (5., mirror); (6., glow) ]) ]
         );
       ])

(* [nested ~start n] is, after [start], a mix nested [n] deep. *)
let nested ?(start = "") n =
  let mixes = String.concat "" (List.init n (fun _ -> "mixed 1 ")) in
  Read.with_header ("sphere 0 0 6 1 " ^ start ^ mixes ^ "reflective")

let test_deepest () =
  let scene = Read.scene (nested Surface.max_nesting) in
  Alcotest.check Same.scene "printed and read" scene
    (Read.scene (Format.asprintf "%a" Raylab_language.Scene_file.print scene))

(* What is wrong before is told as well, and what is in other objects. *)
let test_too_deep () =
  let messages text =
    List.map
      (fun e -> e.Raylab_language.Scene_error.message)
      (Read.errors text)
  in
  let too_deep = "mixes are nested deeper than 1,000" in
  Alcotest.(check (list string))
    "one deeper" [ too_deep ]
    (messages (nested (Surface.max_nesting + 1)));
  Alcotest.(check (list string))
    "other errors"
    [
      "the weight must not be negative, not -3";
      too_deep;
      "the radius must be greater than 0, not 0";
    ]
    (messages
       (nested ~start:"mixed -3 reflective 2 " Surface.max_nesting
       ^ " sphere 0 0 6 0 mixed 1 reflective"))

(* What ends in a mix and is not the last part has a name where it is printed. *)
let test_checkers () =
  let check what text expected =
    check what text expected;
    let scene = Read.scene (Read.with_header ("sphere 0 0 6 1 " ^ text)) in
    let printed = Property.show Raylab_language.Scene_file.print scene in
    Alcotest.check Same.scene "printed" scene (Read.scene printed)
  in
  let open_mix = Surface.mixed [ (3., mirror) ] in
  let ends_open = Surface.checker 2. matt open_mix in
  check "of a mix first" "checker 2 mixed 3 reflective diffusive white"
    (Surface.checker 2. open_mix matt);
  check "a weight after one"
    "mixed 1 checker 2 diffusive white luminous red 4 reflective"
    (Surface.mixed [ (1., Surface.checker 2. matt glow); (4., mirror) ]);
  check "a weight after a mix in one"
    "mixed 1 checker 2 diffusive white mixed 3 reflective 4 luminous red"
    (Surface.mixed
       [
         ( 1.,
           Surface.checker 2. matt (Surface.mixed [ (3., mirror); (4., glow) ])
         );
       ]);
  let scene =
    Scene.make Read.camera
      ~objects:
        [
          Build.sphere (Build.v 0. 0. 6.) 1.
            (Surface.mixed
               [
                 (1., ends_open);
                 (4., Surface.checker 1. glow ends_open);
                 (5., glow);
               ]);
        ]
  in
  let printed = Property.show Raylab_language.Scene_file.print scene in
  Alcotest.check Same.scene "named" scene (Read.scene printed)

let messages text =
  List.map
    (fun e -> e.Raylab_language.Scene_error.message)
    (Read.errors (Read.with_header text))

let test_deep_checkers () =
  let deep n =
    let checkers = List.init n (fun _ -> "checker 1 reflective ") in
    "sphere 0 0 6 1 " ^ String.concat "" checkers ^ "reflective"
  in
  let scene = Read.scene (Read.with_header (deep 1000)) in
  let printed = Property.show Raylab_language.Scene_file.print scene in
  Alcotest.check Same.scene "printed and read" scene (Read.scene printed);
  Alcotest.(check (list string))
    "one deeper"
    [ "checkers are nested deeper than 1,000" ]
    (messages (deep 1001))

(* Each of what the one before is: what is seen grows, and what is written
   does not. *)
let test_doubled () =
  let definition k =
    Printf.sprintf "let c%d = checker 1 c%d c%d\n" k (k - 1) (k - 1)
  in
  let text =
    "let c0 = reflective\n"
    ^ String.concat "" (List.init 99 (fun k -> definition (k + 1)))
    ^ "sphere 0 0 6 1 c99"
  in
  Alcotest.(check (list string))
    "an end"
    [ "the evaluation takes more than 100,000,000 steps" ]
    (messages text)

let test_next_object () =
  Alcotest.(check (list Same.surface))
    "an object ends every mix"
    [
      Surface.mixed [ (1., Surface.mixed [ (2., mirror) ]) ];
      Surface.mixed [ (3., glow) ];
    ]
    (surfaces
       "sphere 0 0 6 1 mixed 1 mixed 2 reflective sphere 0 0 7 1 mixed 3 \
        luminous red")

(* A colour in square brackets weighs each channel. *)
let test_colors () =
  let gold = Color.make 1. 0.78 0.3 in
  check "by name" "mixed [gold] reflective" (Surface.tinted [ (gold, mirror) ]);
  check "in numbers, beside numbers"
    "mixed [1, 0.78, 0.3] reflective 2 luminous red"
    (Surface.tinted [ (gold, mirror); (Color.make 2. 2. 2., glow) ]);
  check "computed" "mixed 1 reflective [2 * [0.5, 0.39, 0.15]] luminous red"
    (Surface.tinted [ (Color.white, mirror); (gold, glow) ]);
  Alcotest.(check (list Same.surface))
    "a name wins over a colour's word"
    [ Surface.tinted [ (Color.red, mirror) ] ]
    (List.map
       (fun (o : Object.t) -> o.surface)
       (Read.scene
          (Read.with_header
             "let gold = 1 0 0 sphere 0 0 6 1 mixed [gold] reflective"))
         .objects)

let test_glass () =
  let gold = Color.make 1. 0.78 0.3 in
  check "glass" "glass 1.5 gold" (Surface.glass ~index:1.5 gold);
  check "refractive" "refractive (3 / 2) [gold]"
    (Surface.refractive ~index:1.5 gold);
  check "glossy" "glossy 20 1 .78 .3" (Surface.glossy ~sharpness:20. gold);
  check "as parts" "mixed 1 glass 1.5 gold 2 glossy 20 gold"
    (Surface.mixed
       [
         (1., Surface.glass ~index:1.5 gold);
         (2., Surface.glossy ~sharpness:20. gold);
       ])

let suite =
  ( "Mixes",
    [
      Alcotest.test_case "flat" `Quick test_flat;
      Alcotest.test_case "innermost" `Quick test_innermost;
      Alcotest.test_case "checkers" `Quick test_checkers;
      Alcotest.test_case "deep checkers" `Quick test_deep_checkers;
      Alcotest.test_case "doubled again and again" `Quick test_doubled;
      Alcotest.test_case "next object" `Quick test_next_object;
      Alcotest.test_case "the deepest" `Quick test_deepest;
      Alcotest.test_case "too deep" `Quick test_too_deep;
      Alcotest.test_case "weights that are colours" `Quick test_colors;
      Alcotest.test_case "glass" `Quick test_glass;
    ] )
