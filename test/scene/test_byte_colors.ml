open Raylab_scene
open Test_support
open Build

let check what expected ?(background = Color.black) ?(ambient = Color.black)
    lights objects =
  Alcotest.(check (list string))
    what expected
    (List.map (Warning.to_string place)
       (Byte_colors.warnings
          ~background:(Background.plain background)
          ~ambient lights objects))

let ball surface = sphere (v 0. 0. 6.) 1. surface
let no what color = check what [] [] [ ball (Surface.luminous color) ]

let test_where () =
  check "the background"
    [
      "the background has the colour 135 206 235, which looks like 0 to 255; \
       from 0 to 1 it is 0.529 0.808 0.922";
    ]
    ~background:(rgb 135. 206. 235.) [] [];
  check "the ambient light"
    [
      "the ambient light has the colour 135 206 235, which looks like 0 to \
       255; from 0 to 1 it is 0.529 0.808 0.922";
    ]
    ~ambient:(rgb 135. 206. 235.) [] [];
  check "a light"
    [
      "light 1 has the colour 255 255 255, which looks like 0 to 255; from 0 \
       to 1 it is 1 1 1";
    ]
    [ Light.spherical ~intensity:1. ~color:(grey 255.) ~position:(v 0. 0. 0.) ]
    [];
  check "a part of a mix"
    [
      "sphere 2 has the colour 0 128 0, which looks like 0 to 255; from 0 to \
       1 it is 0 0.502 0 (line 9)";
    ]
    []
    [
      ball Surface.reflective;
      sphere ~line:9 (v 0. 3. 6.) 1.
        (Surface.mixed
           [
             (1., Surface.reflective); (1., Surface.diffusive (rgb 0. 128. 0.));
           ]);
    ]

let test_others () =
  no "from 0 to 1" (rgb 1. 0.5 0.);
  no "a bright lamp" (rgb 30. 20. 10.);
  no "a very bright one" (rgb 400. 300. 200.);
  no "no whole numbers" (rgb 128.5 64. 0.)

let suite =
  ( "Byte_colors",
    [
      Alcotest.test_case "where" `Quick test_where;
      Alcotest.test_case "others" `Quick test_others;
    ] )
