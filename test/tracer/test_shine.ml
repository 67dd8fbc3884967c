(* Highlights: colours of the ray from (0, 0, -1) along the z axis, which meets a
   wall at (0, 0, 4) and is mirrored back along (0, 0, -1). *)

open Raylab_geometry
open Raylab_scene
open Test_support
open Build

let check = Alcotest.check (Same.color_near 1e-12)
let wall surface = plane (v 0. 0. 4.) (v 0. 0. 1.) surface
let glossy sharpness = Surface.glossy ~sharpness (rgb 0.5 1. 0.25)
let seen ?ambient lights objects = Shot.centre ?ambient ~lights objects

(* The way to the sun has the cosine 0.8 to the mirrored ray, as to the normal:
   0.8^2 = 0.64, 0.8^3 = 0.512. *)
let test_power () =
  let sun = Shot.sun ~intensity:2. 0. (-3.) 4. in
  let seen s = seen [ sun ] [ wall (glossy s) ] in
  check "squared" (rgb 0.64 1.28 0.32) (seen 2.);
  check "cubed" (rgb 0.512 1.024 0.256) (seen 3.);
  check "not at all: 0.8^0" (rgb 1. 2. 0.5) (seen 0.);
  check "0.8^0.5, no whole number"
    (rgb (sqrt 0.8) (2. *. sqrt 0.8) (sqrt 0.8 /. 2.))
    (seen 0.5);
  check "very sharp" Color.black (seen 1e9)

(* Straight back, 5 away: 10 / 25, whatever the sharpness. *)
let test_straight () =
  let bulb = Shot.bulb ~intensity:10. 0. 0. (-1.) in
  check "soft" (rgb 0.2 0.4 0.1) (seen [ bulb ] [ wall (glossy 1.) ]);
  check "sharp" (rgb 0.2 0.4 0.1) (seen [ bulb ] [ wall (glossy 1e6) ])

(* A wall turned by 45 degrees mirrors the ray upwards. From above comes light
   with the whole of its power, though its cosine is sqrt 1/2; from the eye none,
   since the mirrored ray is at a right angle to that, and so 0^0 of it. *)
let test_mirrored () =
  let wall s = plane (v 0. 0. 4.) (v 0. 1. (-1.)) (glossy s) in
  check "from above" (rgb 0.5 1. 0.25)
    (seen [ Shot.sun 0. (-1.) 0. ] [ wall 9. ]);
  check "from the eye" Color.black (seen [ Shot.sun 0. 0. 1. ] [ wall 9. ]);
  check "0^0 is 1" (rgb 0.5 1. 0.25) (seen [ Shot.sun 0. 0. 1. ] [ wall 0. ]);
  check "from behind" Color.black (seen [ Shot.sun 0. 1. 0. ] [ wall 0. ])

let test_what_shines () =
  let bulb = Shot.bulb ~intensity:1000. 0. 8. (-4.) in
  check "in a shadow" Color.black
    (seen [ bulb ] [ wall (glossy 1.); sphere (v 0. 4. 0.) 1. (glossy 1.) ]);
  check "no ambient light" Color.black
    (seen ~ambient:Color.white [] [ wall (glossy 1.) ]);
  let sun = Shot.sun 0. (-3.) 4. in
  check "lights add up" (rgb 0.8 1.6 0.4)
    (seen [ sun; sun ] [ wall (glossy 1.) ]);
  let both =
    Surface.mixed [ (2., glossy 2.); (1., Surface.diffusive (grey 0.5)) ]
  in
  check "beside a matt part: 2 * 0.64 * colour + 0.8 * 0.5"
    (rgb 1.04 1.68 0.72)
    (seen [ sun ] [ wall both ])

(* Of an unfading light far away half is seen; each point of it is straight back
   to a part in a million. *)
let test_area () =
  let light =
    Light.unfading
      (Light.area ~intensity:1. ~color:Color.white
         (Pane.make ~corner:(v (-1.) (-1.) (-9996.)) ~edge:(v 2. 0. 0.)
            ~other:(v 0. 2. 0.) ~count:2))
  and screen =
    Object.make
      (Shape.quad ~corner:(v 0. (-5.) (-5000.)) ~edge:(v 5. 0. 0.)
         ~other:(v 0. 10. 0.))
      (glossy 1.)
  in
  Alcotest.check (Same.color_near 1e-5) "half of it" (rgb 0.25 0.5 0.125)
    (seen [ light ] [ wall (glossy 3.); screen ])

(* Sharpness 1 of a wall that the ray meets straight is as if it were matt. *)
let lambert =
  Property.holds "looked at straight, sharpness 1 is a matt surface" ~count:300
    QCheck2.Gen.(list_size (0 -- 3) (Generate.light Generate.everyday))
    (fun lights ->
      Alcotest.equal (Same.color_about 1e-9)
        (seen lights [ wall (Surface.diffusive (rgb 0.5 1. 0.25)) ])
        (seen lights [ wall (glossy 1.) ]))

let suite =
  ( "Shine",
    [
      Alcotest.test_case "power" `Quick test_power;
      Alcotest.test_case "straight back" `Quick test_straight;
      Alcotest.test_case "mirrored" `Quick test_mirrored;
      Alcotest.test_case "what shines" `Quick test_what_shines;
      Alcotest.test_case "area light" `Quick test_area;
      lambert;
    ] )
