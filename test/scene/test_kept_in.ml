open Raylab_scene
open Test_support
open Build

(* The eye is at (0, 0, -1). *)
let told lights objects =
  Kept_in.warnings (camera ()) lights objects
  |> List.map (Warning.to_string place)

let check what expected lights objects =
  Alcotest.(check (list string)) what expected (told lights objects)

let white = Color.white
let at x y z = Light.spherical ~intensity:1. ~color:white ~position:(v x y z)

let along x y z =
  Light.directional ~intensity:1. ~color:white ~direction:(v x y z)

let matt = Surface.diffusive white
let ball = sphere (v 0. 0. 6.) 1. matt
let room = sphere (v 0. 0. 0.) 20. matt
let floor = plane (v 0. (-2.) 0.) (v 0. 1. 0.) matt

let test_balls () =
  check "inside"
    [ "light 1 is inside sphere 1, which keeps its light in" ]
    [ at 0. 0.5 6. ]
    [ ball ];
  check "of a lamp, which glows"
    [ "light 2 is inside sphere 3, which keeps its light in" ]
    [ at 0. 9. 0.; at 0. 0. 6. ]
    [
      floor;
      sphere (v 3. 0. 6.) 1. matt;
      sphere (v 0. 0. 6.) 1. (Surface.luminous white);
    ];
  check "outside" [] [ at 0. 1.5 6.; at 0. 0. 4.; along 0. (-1.) 0. ] [ ball ];
  check "on the surface" [] [ at 0. 1. 6.; at 0. 0.99999 6. ] [ ball ];
  check "with the eye, in a room" [] [ at 0. 5. 0.; at 0. 0. 6.5 ] [ room ]

let test_room () =
  let outside =
    "light 1 is outside of sphere 1, in which the eye is, and which keeps its \
     light out"
  in
  check "from outside" [ outside ] [ at 0. 30. 0. ] [ room ];
  check "from far away" [ outside ] [ along 0. (-1.) 0. ] [ room ]

(* Light behind one gives nothing either, but a plane is not closed. *)
let test_planes () =
  check "under the floor" []
    [ at 0. (-3.) 0.; along 0. 1. 0.; at 0. 3. 0. ]
    [ floor ]

let test_lines () =
  check "lines"
    [ "light 1 is inside sphere 1, which keeps its light in (lines 4 and 7)" ]
    [ Light.with_origin (at_line 4) (at 0. 0. 6.) ]
    [ sphere ~line:7 (v 0. 0. 6.) 1. matt ]

let test_many () =
  let lights n = List.init n (fun _ -> at 0. 0. 6.) in
  let told n = told (lights n) [ ball ] in
  Alcotest.(check int) "ten are told" 10 (List.length (told 10));
  Alcotest.(check string)
    "and one" "1 more light is like that"
    (List.nth (told 11) 10);
  Alcotest.(check string)
    "and more" "5 more lights are like that"
    (List.nth (told 15) 10);
  let sky = List.init 10_000 (fun _ -> at 0. 9. 0.)
  and crowd = List.init 10_000 (fun _ -> ball) in
  check "not every pair is looked at" [] sky crowd

let suite =
  ( "Kept_in",
    [
      Alcotest.test_case "balls" `Quick test_balls;
      Alcotest.test_case "room" `Quick test_room;
      Alcotest.test_case "planes" `Quick test_planes;
      Alcotest.test_case "lines" `Quick test_lines;
      Alcotest.test_case "many" `Quick test_many;
    ] )
