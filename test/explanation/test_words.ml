open Raylab_scene
open Raylab_explanation
open Test_support
open Build

let check = Alcotest.(check string)

let test_lists () =
  check "none" "" (Words.list []);
  check "one" "a" (Words.list [ "a" ]);
  check "two" "a and b" (Words.list [ "a"; "b" ]);
  check "three" "a, b and c" (Words.list [ "a"; "b"; "c" ]);
  check "six" "1, 2, 3, 4, 5 and 6"
    (Words.list (List.init 6 (fun i -> string_of_int (i + 1))));
  check "hundred" "1, 2, 3, 4, 5 and 95 more"
    (Words.list (List.init 100 (fun i -> string_of_int (i + 1))));
  check "light" "light 4" (Words.lights [ 4 ]);
  check "lights" "lights 1 and 4" (Words.lights [ 1; 4 ])

let test_articles () =
  let articles =
    [
      ("a", [ "red"; "mix"; "12.5 %"; "1 %"; "100 %"; "181 %"; "7 %" ]);
      ("an", [ "orange"; "80 %"; "8.5 %"; "11 %"; "18 %" ]);
    ]
  in
  List.iter
    (fun (article, phrases) ->
      List.iter
        (fun phrase -> check phrase (article ^ " " ^ phrase) (Words.a phrase))
        phrases)
    articles

let test_colors () =
  List.iter
    (fun (r, g, b, word) -> check word word (Color_word.of_color (rgb r g b)))
    [
      (0., 0., 0., "black");
      (0.07, 0., 0.07, "black");
      (0.2, 0.2, 0.2, "dark grey");
      (0.5, 0.5, 0.5, "grey");
      (0.75, 0.7, 0.68, "light grey");
      (1., 1., 1., "white");
      (7., 5., 3., "white");
      (1., 0., 0., "red");
      (0.42, 0.04, 0.08, "dark red");
      (1., 0.6, 0.6, "pink");
      (0.95, 0.4, 0.08, "orange");
      (0.4, 0.2, 0.1, "brown");
      (0.4, 0.32, 0.12, "brown");
      (0.9, 0.72, 0.27, "yellow");
      (0.9, 0.75, 0.55, "beige");
      (1., 1., 0., "yellow");
      (0.5, 0.5, 0., "dark yellow");
      (0., 1., 0., "green");
      (0.08, 0.42, 0.22, "dark green");
      (0., 1., 1., "cyan");
      (0., 0., 1., "blue");
      (0.55, 0.7, 0.9, "light blue");
      (0.5, 0., 1., "purple");
      (1., 0., 1., "magenta");
      (1., 0., 0.2, "red");
    ]

let test_hue () =
  let check what expected color =
    Alcotest.(check (option (float 1e-9))) what expected (Color_word.hue color)
  in
  check "red" (Some 0.) (rgb 3. 0. 0.);
  check "magenta" (Some 300.) Color.magenta;
  check "grey" None (rgb 0.5 0.55 0.5);
  check "black" None (rgb 0.07 0. 0.)

(* The first eight names of the scene language are their own words. *)
let test_names () =
  List.iter
    (fun (name, color) -> check name name (Color_word.of_color color))
    (List.filteri (fun k _ -> k < 8) Color.names)

let any_color =
  let words =
    List.concat_map
      (fun hue -> [ hue; "dark " ^ hue; "light " ^ hue ])
      [ "red"; "yellow"; "green"; "cyan"; "blue"; "purple"; "magenta"; "grey" ]
    @ [ "black"; "white"; "orange"; "brown"; "beige"; "pink" ]
  in
  Property.holds "a word for every colour" ~count:2000
    ~print:(Property.show Color.pp) (Generate.color Generate.extreme) (fun c ->
      List.mem (Color_word.of_color c) words
      && List.mem (snd (Color_word.of_glow c)) words)

let test_glow () =
  let check what expected c =
    Alcotest.(check (pair bool string)) what expected (Color_word.of_glow c)
  in
  check "bright" (false, "yellow") Color.yellow;
  check "faint" (true, "green") (rgb 0. 0.01 0.);
  check "faintest" (true, "blue") (rgb 0. 0. 5e-324);
  check "none" (false, "black") Color.black

(* {1 Objects} *)

let ball surface = sphere (v 0. 0. 0.) 1. surface
let named surface = Naming.by_look 3 (ball surface) surface (place (at_line 8))
let diffusive r g b = Surface.diffusive (rgb r g b)

let test_objects () =
  let mixed = Surface.mixed and reflective = Surface.reflective in
  List.iter
    (fun (expected, surface) -> check expected expected (named surface))
    [
      ("red sphere (object 3, line 8)", diffusive 1. 0. 0.);
      ("mirror (sphere 3, line 8)", reflective);
      ("90 % mirror (sphere 3, line 8)", mixed [ (0.9, reflective) ]);
      ("luminous white sphere (object 3, line 8)", Surface.luminous (grey 9.));
      ( "faintly luminous white sphere (object 3, line 8)",
        Surface.luminous (grey 0.01) );
      ("black sphere (object 3, line 8)", mixed [ (0., reflective) ]);
      ( "mix of 50 % red (sphere 3, line 8)",
        mixed [ (0.5, diffusive 1. 0. 0.) ] );
      ( "mix of 60 % red, 40 % blue and a white glow (sphere 3, line 8)",
        mixed
          [
            (0.3, diffusive 1. 0. 0.);
            (1., Surface.luminous Color.white);
            (0.4, diffusive 0. 0. 1.);
            (0.3, diffusive 0.9 0. 0.);
          ] );
      ( "mix of 50 % mirror and 50 % green (sphere 3, line 8)",
        mixed
          [
            (0.25, reflective);
            (0.5, mixed [ (1., diffusive 0. 1. 0.); (0.5, reflective) ]);
          ] );
    ];
  check "without a line" "red plane (object 1)"
    (Naming.by_look 1
       (plane (v 0. 0. 0.) (v 0. 1. 0.) (diffusive 1. 0. 0.))
       (diffusive 1. 0. 0.) None);
  check "in another file" "mirror (sphere 3, line 7 of wood.scene)"
    (Naming.by_look 3 (ball reflective) reflective (place (at_line_of_wood 7)));
  check "by number" "sphere 2 (line 5)"
    (Naming.by_number 2 (ball reflective) (place (at_line 5)));
  check "by number, in another file" "sphere 2 (line 5 of wood.scene)"
    (Naming.by_number 2 (ball reflective) (place (at_line_of_wood 5)))

let suite =
  ( "Words",
    [
      Alcotest.test_case "lists" `Quick test_lists;
      Alcotest.test_case "articles" `Quick test_articles;
      Alcotest.test_case "colours" `Quick test_colors;
      Alcotest.test_case "hues" `Quick test_hue;
      Alcotest.test_case "the language's colours" `Quick test_names;
      any_color;
      Alcotest.test_case "glow" `Quick test_glow;
      Alcotest.test_case "objects" `Quick test_objects;
    ] )
