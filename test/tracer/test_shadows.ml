open Raylab_scene
open Test_support
open Build

let white = Surface.diffusive Color.white
let glow = Surface.luminous Color.red

(* Pixels look through (i, j, 0), i and j from -5 to 5, and see the point
   (2 i, 2 j) of the wall at z = 10. The sphere of radius 2.5 around (0, 0, 5)
   hides it where 15 p / sqrt (100 + p^2) < 2.5, p^2 = i^2 + j^2: up to p^2 = 2.
   Light along (1, 0, 1) carries its shadow 5 to the right, to the ellipse
   ((X - 5) / 2.5 sqrt 2)^2 + (Y / 2.5)^2 < 1 of the wall. In the middle row
   that is X from 1.46 to 8.54, so 2 (hidden), 4, 6 and 8; in the rows beside,
   where Y = 2, it is X from 2.88 to 7.12, so 4 and 6; then Y = 4 is outside. *)
let test_edge () =
  let scene =
    Scene.make
      (camera ~width:11 ~height:11 ~canvas_width:11. ~canvas_height:11.
         ~depth:10. ())
      ~lights:[ Shot.sun 1. 0. 1. ]
      ~objects:
        [
          sphere (v 0. 0. 5.) 2.5 glow; plane (v 0. 0. 10.) (v 0. 0. 1.) white;
        ]
  in
  let letter = function
    | 255, 0, 0 -> 'O'
    | 0, 0, 0 -> '#'
    | 180, 180, 180 -> '.' (* 255 / sqrt 2 = 180.3 *)
    | _ -> '?'
  in
  let lit = List.init 4 (fun _ -> "...........") in
  Alcotest.(check (list string))
    "the shadow"
    (lit @ [ "....OOO##.."; "....OOO###."; "....OOO##.." ] @ lit)
    (Shot.drawing letter (Shot.picture scene))

(* The wall is hit at (0, 0, 4). The light is at (0, 8, -4), and half way to it
   is (0, 4, 0). Its way has the length sqrt 128, the cosine 8 / sqrt 128. *)
let wall = plane (v 0. 0. 4.) (v 0. 0. 1.) white
let full = 1000. *. 8. /. (128. *. sqrt 128.)

let check what expected objects =
  Alcotest.check (Same.color_near 1e-12) what (grey expected)
    (Shot.centre
       ~lights:[ Shot.bulb ~intensity:1000. 0. 8. (-4.) ]
       (wall :: objects))

let test_what_blocks () =
  check "nothing" full [];
  check "luminous objects too" 0. [ sphere (v 0. 4. 0.) 1. glow ];
  check "mirrors too" 0. [ sphere (v 0. 4. 0.) 1. Surface.reflective ];
  check "planes" 0. [ plane (v 0. 4. 0.) (v 0. 1. 0.) white ];
  check "beside the way" full [ sphere (v 1.01 4. 0.) 1. glow ];
  check "just in the way" 0. [ sphere (v 0.99 4. 0.) 1. glow ]

let test_what_does_not () =
  (* the same line goes on from the light to (0, 12, -8) *)
  check "behind the light" full [ sphere (v 0. 12. (-8.)) 1. glow ];
  check "a plane behind the light" full
    [ plane (v 0. 9. 0.) (v 0. 1. 0.) white ];
  check "behind the point" full [ sphere (v 0. (-4.) 8.) 1. glow ];
  check "around the light, it does" 0. [ sphere (v 0. 8. (-4.)) 1. glow ]

let test_sun () =
  let lit objects =
    Shot.centre ~lights:[ Shot.sun 0. (-3.) 4. ] (wall :: objects)
  in
  let check what expected objects =
    Alcotest.check (Same.color_near 1e-12) what (grey expected) (lit objects)
  in
  check "free" 0.8 [];
  check "far away" 0. [ sphere (v 0. 3000. (-3996.)) 1. glow ];
  check "behind the point" 0.8 [ sphere (v 0. (-3.) 8.) 1. glow ]

(* Light comes straight down, at right angles through what lies flat above the
   middle of a floor that the eye's ray meets aslant: each surface of glass
   takes 4 %. *)
let test_through () =
  let open Raylab_geometry in
  let floor = plane (v 0. 0. 4.) (v 0. 0.6 (-0.8)) white in
  let slab z surface =
    (* across the way to the sun, which shines along the normal *)
    Object.make
      (Shape.quad
         ~corner:
           (Vec3.add (v (-5.) (-4.) (-3.))
              (Vec3.add (v 0. 0. 4.) (Vec3.scale z (v 0. 0.6 (-0.8)))))
         ~edge:(v 10. 0. 0.) ~other:(v 0. 8. 6.))
      surface
  in
  let check what expected objects =
    Alcotest.check (Same.color_near 1e-12) what expected
      (Shot.centre ~lights:[ Shot.sun 0. (-0.6) 0.8 ] (floor :: objects))
  in
  let glass = Surface.glass ~index:1.5 in
  let clear = Surface.refractive ~index:1.5 and gold = rgb 1. 0.5 0.25 in
  check "nothing" (grey 1.) [];
  check "what refracts tints" gold [ slab 20. (clear gold) ];
  check "glass takes 4 % besides" (rgb 0.96 0.48 0.24)
    [ slab 20. (glass gold) ];
  check "one after the other" (rgb 0.96 0.24 0.06)
    [ slab 20. (glass gold); slab 21. (clear gold) ];
  check "what is matt besides lets its part through" (rgb 0.5 0.25 0.125)
    [ slab 20. (Surface.mixed [ (0.5, clear gold); (0.5, white) ]) ];
  check "what is black lets nothing through" (grey 0.)
    [ slab 20. (clear Color.black) ];
  check "what is matt blocks behind glass" (grey 0.)
    [ slab 20. (glass gold); slab 21. white ];
  check "and before it" (grey 0.) [ slab 21. (glass gold); slab 20. white ];
  check "what is shadowless is not met" (grey 1.)
    [ Object.shadowless (slab 20. (glass gold)) ]

let suite =
  ( "Shadows",
    [
      Alcotest.test_case "edge" `Quick test_edge;
      Alcotest.test_case "what blocks" `Quick test_what_blocks;
      Alcotest.test_case "what does not" `Quick test_what_does_not;
      Alcotest.test_case "directional light" `Quick test_sun;
      Alcotest.test_case "through glass" `Quick test_through;
    ] )
