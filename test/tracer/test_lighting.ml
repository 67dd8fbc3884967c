(* Colours of the ray from (0, 0, -1) along the z axis. *)

open Raylab_geometry
open Raylab_scene
open Raylab_tracer
open Test_support
open Build

let check = Alcotest.check (Same.color_near 1e-12)
let wall surface = plane (v 0. 0. 4.) (v 0. 0. 1.) surface
let half = Surface.diffusive (rgb 0.5 1. 0.25)

let lit ?background ?ambient lights objects =
  Shot.centre ?background ?ambient ~lights objects

(* The sphere is hit at (0, 0, 4), 5 from the light at the eye, which it faces:
   10 / 25 * (0.5, 1, 0.25). *)
let test_sphere () =
  check "from the eye" (rgb 0.2 0.4 0.1)
    (lit
       [ Shot.bulb ~intensity:10. 0. 0. (-1.) ]
       [ sphere (v 0. 0. 5.) 1. half ])

(* From (0, 0, 4) to the light it is (0, 3, -4), of length 5: the cosine is
   4/5, the fall-off 1/25. Twice as far it is a quarter. *)
let test_fall_off () =
  let at k = Shot.bulb ~intensity:50. 0. (3. *. k) (4. -. (4. *. k)) in
  check "at 5: 0.8 * 50 / 25 = 1.6" (rgb 0.8 1.6 0.4)
    (lit [ at 1. ] [ wall half ]);
  check "at 10: 0.4" (rgb 0.2 0.4 0.1) (lit [ at 2. ] [ wall half ])

(* Along (0, -3, 4) / 5 the cosine is 0.8, at any distance. *)
let test_sun () =
  check "0.8 * 2 * colour" (rgb 0.8 1.6 0.4)
    (lit [ Shot.sun ~intensity:2. 0. (-3.) 4. ] [ wall half ]);
  check "from behind the wall" Color.black
    (lit [ Shot.sun 0. (-3.) (-4.) ] [ wall half ]);
  check "along the wall" Color.black (lit [ Shot.sun 0. 1. 0. ] [ wall half ])

let test_colors () =
  let red =
    Light.directional ~intensity:1. ~color:Color.red ~direction:(v 0. 0. 1.)
  and dim =
    Light.directional ~intensity:0.5 ~color:Color.cyan ~direction:(v 0. 0. 1.)
  in
  check "lights add up" (rgb 0.5 0.5 0.125) (lit [ red; dim ] [ wall half ]);
  check "each through the albedo" (rgb 0.5 0. 0.) (lit [ red ] [ wall half ])

let test_two_sides () =
  let lights = [ Shot.sun 0. 0. 1. ] in
  let seen normal_z = plane (v 0. 0. 4.) (v 0. 0. normal_z) half in
  check "one" (rgb 0.5 1. 0.25) (lit lights [ seen 1. ]);
  check "the other" (rgb 0.5 1. 0.25) (lit lights [ seen (-1.) ])

let test_luminous () =
  let glow = wall (Surface.luminous (rgb 0.1 0.2 3.)) in
  check "without light" (rgb 0.1 0.2 3.) (lit [] [ glow ]);
  check "whatever the light" (rgb 0.1 0.2 3.)
    (lit [ Shot.sun 0. 0. 1. ] [ glow ])

let test_background () =
  let background = rgb 0.1 0.2 0.3 in
  check "nothing there" background (lit ~background [] []);
  check "only behind" background
    (lit ~background [] [ plane (v 0. 0. (-2.)) (v 0. 0. 1.) half ])

(* Ambient light has no direction and no shadow. *)
let test_ambient () =
  let ambient = rgb 0.2 0.1 0.4 in
  check "alone" (rgb 0.1 0.1 0.1) (lit ~ambient [] [ wall half ]);
  check "with a sun: half * (ambient + 1)" (rgb 0.6 1.1 0.35)
    (lit ~ambient [ Shot.sun 0. 0. 1. ] [ wall half ]);
  check "in a shadow" (rgb 0.1 0.1 0.1)
    (lit ~ambient
       [ Shot.bulb 0. 8. (-4.) ]
       [ wall half; sphere (v 0. 4. 0.) 1. half ]);
  check "not where nothing is diffused" (rgb 0.5 0.5 0.5)
    (lit ~ambient [] [ wall (Surface.luminous (grey 0.5)) ]);
  check "not in the background" Color.black (lit ~ambient [] [])

(* The wall is hit at (0, 0, 4). Far above before it lie two points on the way
   to which is a quad that hides one half of the light, whatever the place of
   the points in their cells: an unfading light of 2 x 2 points, of which two
   are seen, each at a cosine of 1 to a part in a million. *)
let test_area () =
  let light =
    Light.unfading
      (Light.area ~intensity:1. ~color:Color.white
         (Pane.make ~corner:(v (-1.) (-1.) (-9996.)) ~edge:(v 2. 0. 0.)
            ~other:(v 0. 2. 0.) ~count:2))
  and near = Alcotest.check (Same.color_near 1e-6)
  and screen =
    Object.make
      (Shape.quad ~corner:(v 0. (-5.) (-5000.)) ~edge:(v 5. 0. 0.)
         ~other:(v 0. 10. 0.))
      half
  in
  near "all of it" (rgb 0.5 1. 0.25) (lit [ light ] [ wall half ]);
  near "half of it" (rgb 0.25 0.5 0.125) (lit [ light ] [ wall half; screen ])

(* What lights give adds up. *)
let sums =
  Property.holds "each light adds what it gives alone" ~count:300
    ~print:(Property.show Scene.pp)
    (Generate.scene ~max_side:4 Generate.everyday) (fun scene ->
      let with_lights lights =
        Scene.make ~ray_depth:1 ~lights ~objects:scene.objects scene.camera
        |> Prepared.make
      in
      let dark = with_lights [] and all = with_lights scene.lights in
      let alone = List.map (fun l -> with_lights [ l ]) scene.lights in
      let is_sum ray =
        let color scene = Tracer.color scene ray in
        (* each brings the dark scene once more *)
        let sum = List.fold_left Color.add Color.black in
        Alcotest.equal (Same.color_about 1e-9)
          (sum (color dark :: List.map color alone))
          (sum (color all :: List.map (fun _ -> color dark) alone))
      in
      Seq.for_all is_sum (Camera.primary_rays scene.camera))

let test_over_exposed () =
  let color = lit [ Shot.sun ~intensity:10. 0. 0. 1. ] [ wall half ] in
  check "the colour goes on" (rgb 5. 10. 2.5) color;
  Alcotest.check Same.levels "the levels do not" (255, 255, 255)
    (Color.to_bytes color)

(* Red light on red, both greys by luminance: 0.2126^2, in each channel. *)
let test_grey () =
  let scene =
    Scene.make (camera ())
      ~lights:
        [
          Light.directional ~intensity:1. ~color:Color.red
            ~direction:(v 0. 0. 1.);
        ]
      ~objects:[ wall (Surface.diffusive Color.red) ]
  in
  let trace scene = Tracer.pixel (Prepared.make scene) ~x:0 ~y:0 in
  check "in colour" Color.red (trace scene);
  check "in grey" (grey 0.04519876) (trace (Scene.greyscale scene))

let suite =
  ( "Lighting",
    [
      Alcotest.test_case "a lit sphere" `Quick test_sphere;
      Alcotest.test_case "fall-off" `Quick test_fall_off;
      Alcotest.test_case "directional light" `Quick test_sun;
      Alcotest.test_case "coloured lights" `Quick test_colors;
      Alcotest.test_case "planes have two sides" `Quick test_two_sides;
      Alcotest.test_case "luminous" `Quick test_luminous;
      Alcotest.test_case "background" `Quick test_background;
      Alcotest.test_case "ambient light" `Quick test_ambient;
      Alcotest.test_case "area light" `Quick test_area;
      sums;
      Alcotest.test_case "over-exposure" `Quick test_over_exposed;
      Alcotest.test_case "greyscale" `Quick test_grey;
    ] )
