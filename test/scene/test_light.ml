open Raylab_geometry
open Raylab_scene
open Test_support
open Build

let check_color = Alcotest.check (Same.color_near 1e-15)
let check_number = Alcotest.check (Same.near 1e-15)
let up = dir 0. 1. 0.

(* Travels to the right and down, so it comes from (-0.6, 0.8, 0). *)
let sun =
  Light.directional ~intensity:2. ~color:(rgb 1. 0.5 0.)
    ~direction:(v 3. (-4.) 0.)

let bulb =
  Light.spherical ~intensity:50. ~color:(rgb 1. 0.5 0.) ~position:(v 3. 4. 0.)

(* How a light meets a surface. *)
let meet ?(offset = 0.) light ~point ~normal =
  let incidence = Incidence.create () in
  let faces =
    Incidence.meet light 0 (Raw_ray.create ())
      (Spot.of_point ~point ~normal ~offset)
      incidence
  in
  Alcotest.(check bool) "faces" (incidence.cosine > 0.) faces;
  incidence

(* What a light gives to what it meets so. *)
let give light ~cosine ~falloff =
  let color = Raw_color.create () and incidence = Incidence.create () in
  incidence.cosine <- cosine;
  incidence.falloff <- falloff;
  Incidence.add light incidence color;
  Raw_color.to_color color

let test_directional () =
  let incidence = meet sun ~point:(v 7. 7. 7.) ~normal:up in
  check_number "cosine" 0.8 incidence.cosine;
  check_number "no fall-off" 1. incidence.falloff;
  (* 0.8 * 2 * (1, 0.5, 0) *)
  check_color "received" (rgb 1.6 0.8 0.)
    (Incidence.received sun ~point:(v 7. 7. 7.) ~normal:up)

(* The light is 5 away, 4 of it along the normal: cosine 4/5, fall-off 1/25. *)
let test_point () =
  let incidence = meet bulb ~point:Vec3.zero ~normal:up in
  check_number "cosine" 0.8 incidence.cosine;
  check_number "fall-off" 0.04 incidence.falloff;
  (* 0.8 * 0.04 * 50 * (1, 0.5, 0) *)
  check_color "received" (rgb 1.6 0.8 0.)
    (Incidence.received bulb ~point:Vec3.zero ~normal:up)

let test_facing_away () =
  let down = dir 0. (-1.) 0. in
  List.iter
    (fun light ->
      let incidence = meet light ~point:Vec3.zero ~normal:down in
      check_number "negative cosine" (-0.8) incidence.cosine;
      check_color "nothing" Color.black
        (Incidence.received light ~point:Vec3.zero ~normal:down))
    [ sun; bulb ];
  check_color "along the surface" Color.black
    (Incidence.received sun ~point:Vec3.zero ~normal:(dir 0. 0. 1.))

(* No square of a distance, no light. *)
let test_at_the_light () =
  let none what ?offset light ~point =
    check_number what 0. (meet ?offset light ~point ~normal:up).cosine;
    if offset = None then
      check_color what Color.black (Incidence.received light ~point ~normal:up)
  in
  none "at the light" bulb ~point:(v 3. 4. 0.);
  let above y =
    Light.spherical ~intensity:1. ~color:Color.white ~position:(v 0. y 0.)
  in
  none "farther than a double" (above max_float) ~point:(v 0. (-.max_float) 0.);
  none "farther than squares" (above 1e154) ~point:Vec3.zero;
  none "nearer than squares" (above 1e-170) ~point:Vec3.zero;
  none "nothing to an offset as large" ~offset:1e151 (above 1e100)
    ~point:Vec3.zero;
  check_number "as far as squares reach" 1.
    (meet (above 1e153) ~point:Vec3.zero ~normal:up).cosine

(* cosine * falloff * intensity * colour, the product from the left, limited
   at each step. *)
let test_give () =
  check_color "intensity * colour" (rgb 50. 25. 0.)
    (give bulb ~cosine:1. ~falloff:1.);
  check_color "all four" (rgb 1.6 0.8 0.) (give bulb ~cosine:0.8 ~falloff:0.04);
  let blinding =
    Light.directional ~intensity:1e200 ~color:(rgb 1e200 1. 0.)
      ~direction:(v 0. (-1.) 0.)
  in
  check_color "at most max_float" (rgb max_float 1e200 0.)
    (give blinding ~cosine:1. ~falloff:1.);
  check_color "so is what is received" (rgb max_float 1e200 0.)
    (Incidence.received blinding ~point:Vec3.zero ~normal:up);
  check_color "nothing of a channel stays nothing"
    (rgb max_float max_float 0.)
    (give blinding ~cosine:1. ~falloff:max_float)

(* 1 / (1e-155)^2 is no double either. *)
let test_very_near () =
  let light =
    Light.spherical ~intensity:1. ~color:Color.red ~position:(v 0. 1e-155 0.)
  in
  check_color "at most max_float" (rgb max_float 0. 0.)
    (Incidence.received light ~point:Vec3.zero ~normal:up)

let test_values () =
  Alcotest.(check string) "name" "directional" (Light.name sun);
  Alcotest.(check string) "name" "spherical" (Light.name bulb);
  Expect.prints "directional"
    "directional light, intensity 1, rgb 1 1 1, direction (0, -1, 0)" Light.pp
    (Light.directional ~intensity:1. ~color:Color.white
       ~direction:(v 0. (-1.) 0.));
  Expect.prints "spherical"
    "spherical light, intensity 1, rgb 1 1 1, position (0, 5, 0)" Light.pp
    (Light.spherical ~intensity:1. ~color:Color.white ~position:(v 0. 5. 0.));
  Alcotest.check Same.light "origins do not count" bulb
    (Light.with_origin (at_line 9) bulb);
  Alcotest.(check bool) "kinds differ" false (Light.equal sun bulb);
  check_color "map_color" Color.blue
    (Light.map_color (fun _ -> Color.blue) bulb).color

let test_invalid () =
  let color = Color.white and at = v 1. 2. 3. in
  List.iter
    (fun bad ->
      Expect.invalid "intensity" (fun () ->
          Light.spherical ~intensity:bad ~color ~position:at);
      Expect.invalid "colour" (fun () ->
          Light.directional ~intensity:1. ~color:(rgb 0. bad 0.) ~direction:at))
    [ nan; infinity; -1. ];
  List.iter
    (fun at ->
      Expect.invalid "position" (fun () ->
          Light.spherical ~intensity:1. ~color ~position:at);
      Expect.invalid "direction" (fun () ->
          Light.directional ~intensity:1. ~color ~direction:at))
    [ v nan 0. 0.; v 0. infinity 0.; v 0. 0. neg_infinity ];
  Expect.invalid "zero direction" (fun () ->
      Light.directional ~intensity:1. ~color ~direction:Vec3.zero)

let finite =
  Property.holds "what is received is finite, whatever the numbers" ~count:2000
    QCheck2.Gen.(
      triple
        (Generate.light Generate.extreme)
        (Generate.vec3 Generate.extreme)
        (Generate.direction Generate.extreme))
    (fun (light, point, normal) ->
      let c = Incidence.received light ~point ~normal in
      List.for_all (fun x -> Float.is_finite x && x >= 0.) [ c.r; c.g; c.b ])

let suite =
  ( "Light",
    [
      Alcotest.test_case "directional" `Quick test_directional;
      Alcotest.test_case "point" `Quick test_point;
      Alcotest.test_case "facing away" `Quick test_facing_away;
      Alcotest.test_case "at the light" `Quick test_at_the_light;
      Alcotest.test_case "give" `Quick test_give;
      Alcotest.test_case "very near" `Quick test_very_near;
      Alcotest.test_case "values" `Quick test_values;
      Alcotest.test_case "invalid" `Quick test_invalid;
      finite;
    ] )
