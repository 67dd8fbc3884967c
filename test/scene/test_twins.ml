open Raylab_scene
open Test_support
open Build

let told objects = List.map (Warning.to_string place) (Twins.warnings objects)

let check what expected objects =
  Alcotest.(check (list string)) what expected (told objects)

let matt = Surface.diffusive Color.white
let floor = plane (v 0. (-2.) 0.) (v 0. 1. 0.) matt
let second = "plane 2 is where plane 1 is: they hide each other"

let test_planes () =
  let same what other = check what [ second ] [ floor; other ] in
  same "again" floor;
  same "of another surface"
    (plane (v 0. (-2.) 0.) (v 0. 1. 0.) Surface.reflective);
  same "through another point" (plane (v 7. (-2.) 3.) (v 0. 1. 0.) matt);
  same "of a longer normal" (plane (v 0. (-2.) 0.) (v 0. 3. 0.) matt);
  same "from below" (plane (v 1. (-2.) 0.) (v 0. (-3.) 0.) matt);
  let others =
    [
      floor;
      plane (v 0. (-1.) 0.) (v 0. 1. 0.) matt;
      plane (v 0. 2. 0.) (v 0. 1. 0.) matt;
      plane (v 0. (-2.) 0.) (v 0.001 1. 0.) matt;
    ]
  in
  check "others" [] others

(* Whatever points and normals a plane is made of. *)
let any_plane =
  let open QCheck2.Gen in
  let number = float_range (-10.) 10. in
  let vec = map3 v number number number in
  Property.holds "any plane" ~count:1000
    (tup4 vec
       (Generate.direction number)
       (pair number number)
       (oneof [ float_range 0.1 10.; float_range (-10.) (-0.1) ]))
    (fun (point, normal, (a, b), k) ->
      let open Raylab_geometry in
      let n = (normal : Direction.t :> Vec3.t) in
      (* two ways across the normal *)
      let across =
        Vec3.add
          (Vec3.scale a (v n.y (-.n.x) 0.))
          (Vec3.scale b (v 0. n.z (-.n.y)))
      in
      told
        [
          plane point n matt;
          plane (Vec3.add point across) (Vec3.scale k n) matt;
        ]
      = [ second ])

let test_spheres () =
  let ball = sphere (v 0. 0. 6.) 1. in
  check "the same"
    [ "sphere 2 is where sphere 1 is: they hide each other" ]
    [ ball matt; ball Surface.reflective ];
  check "zeros are alike"
    [ "sphere 2 is where sphere 1 is: they hide each other" ]
    [ ball matt; sphere (v (-0.) 0. 6.) 1. matt ];
  check "others" []
    [
      ball matt; sphere (v 0. 0. 6.) 1.000001 matt; sphere (v 0. 0. 7.) 1. matt;
    ]

(* What is changed has many numbers, and begins as others do. *)
let test_changed () =
  let open Raylab_geometry in
  let egg way =
    let change =
      Change.of_modifiers [ Stretched (v 1. 2. 3.); Translated way ]
    in
    Object.transformed change (sphere (v 0. 0. 6.) 1. matt)
  in
  check "the same"
    [ "sphere 2 is where sphere 1 is: they hide each other" ]
    [ egg (v 1. 2. 3.); egg (v 1. 2. 3.) ];
  check "others" [] (List.init 100 (fun k -> egg (v 1. 2. (float_of_int k))))

let test_several () =
  check "each with the first, and the lines"
    [
      "sphere 3 is where sphere 1 is: they hide each other (lines 4 and 6)";
      "sphere 4 is where sphere 1 is: they hide each other (lines 4 and 7)";
    ]
    (List.map
       (fun (line, x) -> sphere ~line (v x 0. 6.) 1. matt)
       [ (4, 0.); (5, 1.); (6, 0.); (7, 0.) ])

let test_of_two_files () =
  let o line_origin =
    Object.make ~origin:line_origin (sphere (v 0. 0. 6.) 1. matt).shape matt
  in
  check "the files"
    [
      "sphere 2 is where sphere 1 is: they hide each other (line 4 and line 9 \
       of wood.scene)";
    ]
    [ o (at_line 4); o (at_line_of_wood 9) ]

let suite =
  ( "Twins",
    [
      Alcotest.test_case "planes" `Quick test_planes;
      Alcotest.test_case "spheres" `Quick test_spheres;
      Alcotest.test_case "changed ones" `Quick test_changed;
      Alcotest.test_case "several" `Quick test_several;
      Alcotest.test_case "of two files" `Quick test_of_two_files;
      any_plane;
    ] )
