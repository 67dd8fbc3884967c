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

let glass = Surface.glass ~index:1.5 Color.white
let ball surface = sphere (v 0. 0. 5.) 1. surface

let prepare ?(camera = camera ()) surfaces =
  Prepared.make ~index:Index.brute_force
    (Scene.make camera ~objects:(List.map ball surfaces))

(* What the surface of each object denotes. *)
let lobes ({ surfaces; _ } : Prepared.t) =
  let read row =
    if row < 0 then Raw_lobes.read (Surfaces.rich surfaces row)
    else
      let color lobe =
        let channel k = surfaces.lobes.(row + lobe + k) in
        rgb (channel 0) (channel 1) (channel 2)
      in
      {
        Lobes.none with
        emission = color Raw_lobes.emission;
        albedo = color Raw_lobes.albedo;
        mirror = color Raw_lobes.mirror;
      }
  in
  Array.to_list (Array.map read surfaces.rows)

let test_lobes () =
  let bright = Surface.mixed [ (0.5, glass); (2., matt) ] in
  let surfaces = [ glow; bright; matt; glass; nested; nested; matt ] in
  Alcotest.(check (list Same.lobes))
    "what its surface denotes"
    (List.map (fun s -> Surface.lobes s) surfaces)
    (lobes (prepare surfaces))

(* A million objects of one surface take the room of one. *)
let test_shared () =
  let { Prepared.surfaces = { rows; lobes; rich; _ }; _ } =
    prepare [ matt; nested; nested; glass; glass; glow; nested ]
  in
  Alcotest.(check (array int))
    "neighbours share"
    [| 0; 9; 9; -3; -3; 18; 27 |]
    rows;
  Alcotest.(check int) "a row each" (4 * 9) (Array.length lobes);
  Alcotest.(check int) "of glass one" 1 (Array.length rich)

let test_offset () =
  let camera = camera ~canvas_width:8. ~canvas_height:4. ~depth:16. () in
  Alcotest.check Same.number "1e-5 of the smallest" 4e-5
    (prepare ~camera []).offset

(* Fans, grid and hierarchy find what trying every shape finds. *)
let many_rays what number =
  Property.holds ("many rays change no pixel, " ^ what) ~count:100
    (Generate.scene ~max_side:12 number) (fun scene ->
      let picture index =
        Prepared.make ~index scene
        |> Prepared.for_many_rays ~rays:max_int
        |> Render.picture ~domains:1 |> fst
      in
      Picture.equal
        (picture (fun shapes -> Index.hierarchy shapes))
        (picture Index.brute_force))

let suite =
  ( "Prepared",
    [
      Alcotest.test_case "lobes" `Quick test_lobes;
      Alcotest.test_case "shared rows" `Quick test_shared;
      Alcotest.test_case "offset" `Quick test_offset;
      many_rays "everyday" Generate.everyday;
      many_rays "any size" Generate.extreme;
    ] )
