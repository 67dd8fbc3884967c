open Raylab_geometry
open Raylab_scene
open Raylab_tracer
open Test_support
open Build

let glow = Surface.luminous (rgb 1. 2. 3.)
let matt = Surface.diffusive (rgb 0.5 0. 0.)

let nested =
  Surface.mixed
    [
      (1., matt); (2., Surface.mixed [ (0.5, Surface.reflective); (1., glow) ]);
    ]

let ball surface = sphere (v 0. 0. 5.) 1. surface

let prepare ?(camera = camera ()) surfaces =
  Prepared.make ~index:Finder.brute_force
    (Scene.make camera ~objects:(List.map ball surfaces))

(* What the surface of each object denotes. *)
let lobes (prepared : Prepared.t) =
  Array.to_list (Array.map (Raw_lobes.read prepared.lobes) prepared.rows)

let test_lobes () =
  let surfaces = [ glow; matt; nested; nested; matt ] in
  Alcotest.(check (list Same.lobes))
    "what its surface denotes"
    (List.map (fun s -> Surface.lobes s) surfaces)
    (lobes (prepare surfaces))

(* A million objects of one surface take the room of one. *)
let test_shared () =
  let { Prepared.rows; lobes; _ } =
    prepare [ matt; nested; nested; glow; nested ]
  in
  Alcotest.(check (array int)) "neighbours share" [| 0; 9; 9; 18; 27 |] rows;
  (* and two that the mix of mixes is worked out in *)
  Alcotest.(check int) "a row each" (6 * 9) (Array.length lobes)

let test_levels () =
  let check what expected surfaces =
    Alcotest.(check int) what expected (prepare surfaces).levels
  in
  check "no object" 1 [];
  check "no mix" 1 [ glow; matt ];
  check "the deepest" 3 [ matt; nested; glow ]

let test_offset () =
  let camera = camera ~canvas_width:8. ~canvas_height:4. ~depth:16. () in
  Alcotest.check Same.number "1e-5 of the smallest" 4e-5
    (prepare ~camera []).offset

let suite =
  ( "Prepared",
    [
      Alcotest.test_case "lobes" `Quick test_lobes;
      Alcotest.test_case "shared rows" `Quick test_shared;
      Alcotest.test_case "levels" `Quick test_levels;
      Alcotest.test_case "offset" `Quick test_offset;
    ] )
