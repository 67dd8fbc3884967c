(* With fans an index must answer as without, shape for shape: rays of the eye,
   shadow rays to lights, and all others. *)

open Raylab_geometry
open Raylab_scene
open Test_support

let answers index rays =
  let { Finder.nearest; blocked } = Index.ask index
  and meeting = Meeting.create () in
  List.map
    (fun (series, ray) ->
      let asked = Ray.to_raw ray in
      nearest asked meeting;
      let met =
        if Meeting.is_none meeting then None
        else Some (meeting.number, meeting.part, asked.reach)
      in
      (met, blocked series (Ray.to_raw ray)))
    rays

type fans = { eye : Fan.source; lights : Fan.source list }

let fans_of ~eye ~look_at ~width ~height ~lamp ~towards =
  let { Viewpoint.right; above; forward; _ } =
    match Viewpoint.make ~look_at eye with
    | Ok viewpoint -> viewpoint
    | Error _ -> Viewpoint.before_origin 1.
  in
  {
    eye = Eye { eye; right; above; forward; width; height };
    lights = [ Point lamp; Along towards ];
  }

let index { eye; lights } shapes =
  let lights = Array.of_list (List.map Option.some lights) in
  Index.for_many_rays ~eye ~lights (Index.hierarchy shapes)

(* {1 Rays} *)

(* Through the place (u, v) of the canvas, from -1 to 1 and a little beyond. *)
let eye_ray source (u, v) =
  match source with
  | Fan.Eye { eye; right; above; forward; width; height } ->
      let open Vec3.Infix in
      let d =
        (forward :> Vec3.t)
        + (u *. width /. 2. * (right :> Vec3.t))
        + (v *. height /. 2. * (above :> Vec3.t))
      in
      Option.map
        (fun direction -> Ray.make ~origin:eye ~direction)
        (Direction.of_vec3 d)
  | Point _ | Along _ -> None

let shadow_ray source origin =
  match source with
  | Fan.Point target -> Ray.towards ~origin ~target ~short:0.
  | Along d ->
      let direction = Direction.of_vec3_exn (Vec3.neg (d :> Vec3.t)) in
      Some (Ray.make ~origin ~direction)
  | Eye _ -> None

let rays { eye; lights } places origins =
  let of_eye = List.filter_map (eye_ray eye) places in
  let of_light series light =
    List.filter_map
      (fun origin ->
        Option.map (fun ray -> (series + 1, ray)) (shadow_ray light origin))
      origins
  in
  List.map (fun ray -> (0, ray)) of_eye
  @ List.concat (List.mapi of_light lights)

let agrees_with plain (shapes, fans, places, origins) =
  let rays = rays fans places origins in
  answers (index fans shapes) rays = answers (plain shapes) rays

let agrees case = agrees_with Index.brute_force case

(* From very far away the hierarchy is not as brute force, and is asked. *)
let is_as_without case = agrees_with (fun s -> Index.hierarchy s) case

(* {1 Any shapes} *)

let place =
  QCheck2.Gen.(pair (float_range (-1.1) 1.1) (float_range (-1.1) 1.1))

let fans number =
  QCheck2.Gen.(
    let* eye = Generate.vec3 number in
    let* look_at = Generate.vec3 number in
    let* width = float_range 0.1 20. in
    let* height = float_range 0.1 20. in
    let* lamp = Generate.vec3 number in
    let+ towards = Generate.direction number in
    fans_of ~eye ~look_at ~width ~height ~lamp ~towards)

let case sizes number =
  QCheck2.Gen.(
    quad
      (array_size sizes (Generate.shape number))
      (fans number)
      (list_size (1 -- 30) place)
      (list_size (1 -- 30) (Generate.vec3 number)))

let pp_source ppf = function
  | Fan.Eye { eye; forward; width; height; _ } ->
      Format.fprintf ppf "eye %a towards %a, %g x %g" Vec3.pp eye Direction.pp
        forward width height
  | Point lamp -> Format.fprintf ppf "lamp %a" Vec3.pp lamp
  | Along towards -> Format.fprintf ppf "light along %a" Direction.pp towards

let print (shapes, { eye; lights }, places, origins) =
  Format.asprintf "%a@.%a@.%a@.%a"
    (Format.pp_print_list Shape.pp)
    (Array.to_list shapes)
    (Format.pp_print_list pp_source)
    (eye :: lights)
    (Format.pp_print_list (fun ppf (u, v) -> Format.fprintf ppf "at %h %h" u v))
    places
    (Format.pp_print_list Vec3.pp)
    origins

let holds ?(law = agrees) name count gen =
  Property.holds name ~count ~print gen law

(* {1 What a grid has trouble with} *)

let sphere x y z radius = Shape.sphere ~centre:(Vec3.make x y z) ~radius
let state = Random.State.make [| 17 |]
let between low high = low +. Random.State.float state (high -. low)

let somewhere size =
  Vec3.make (between (-.size) size) (between (-.size) size)
    (between (-.size) size)

let check_same name ~size shapes =
  let places =
    List.init 400 (fun _ -> (between (-1.05) 1.05, between (-1.05) 1.05))
  and origins = List.init 400 (fun _ -> somewhere size) in
  let fans =
    fans_of
      ~eye:(Vec3.make 0.1 0.2 (-1.5 *. size))
      ~look_at:Vec3.zero ~width:1.2 ~height:0.9
      ~lamp:(Vec3.make 0. (0.9 *. size) 0.)
      ~towards:(Direction.of_vec3_exn (Vec3.make 1. (-2.) 1.5))
  and inside =
    fans_of
      ~eye:(somewhere (0.3 *. size))
      ~look_at:(somewhere size) ~width:2. ~height:2.
      ~lamp:(somewhere (0.3 *. size))
      ~towards:(Direction.of_vec3_exn (Vec3.make 0. 0. 1.))
  in
  let check what fans =
    Alcotest.(check bool)
      (name ^ what) true
      (agrees (shapes, fans, places, origins))
  in
  check ", from outside" fans;
  check ", from inside" inside

let cloud n ~size ~radius =
  Array.init n (fun _ ->
      let { Vec3.x; y; z } = somewhere size in
      sphere x y z (radius ()))

let test_clouds () =
  check_same "a cloud" ~size:10.
    (cloud 5000 ~size:10. ~radius:(fun () -> between 0.05 0.4));
  check_same "sizes from 1e-6 to 1e6" ~size:10.
    (cloud 2000 ~size:10. ~radius:(fun () -> 10. ** between (-6.) 1.)
    |> Array.append [| sphere 0. (-1e6) 0. 999_990.; sphere 0. 0. 0. 1e6 |]);
  check_same "far from the origin" ~size:1e6
    (cloud 2000 ~size:1e6 ~radius:(fun () -> between 1. 1e4))

(* A cell with very many small ones beside large ones. *)
let test_crowds () =
  let small =
    Array.init 4000 (fun _ ->
        let { Vec3.x; y; z } = somewhere 0.02 in
        sphere (5. +. x) y z 0.0005)
  and large = cloud 50 ~size:10. ~radius:(fun () -> between 0.5 2.) in
  check_same "thousands in a cell" ~size:10. (Array.append small large);
  check_same "all around one point" ~size:10.
    (Array.init 3000 (fun k -> sphere 0. 0. 0. (1e-3 *. float_of_int (k + 1))))

(* Boxes, and triangles in the planes of which the lamp lies. *)
let test_flat () =
  let box _ =
    let corner = somewhere 10. in
    let opposite = Vec3.add corner (somewhere 1.) in
    Shape.box_between ~corner ~opposite
  and upright _ =
    (* in the plane x = 0, where the first lamp is *)
    let y = between (-10.) 8. and z = between (-10.) 10. in
    Shape.triangle (Vec3.make 0. y z)
      (Vec3.make 0. (y +. 1.) z)
      (Vec3.make 0. y (z +. 1.))
  in
  check_same "boxes" ~size:10. (Array.init 1500 box);
  check_same "triangles edge on" ~size:10. (Array.init 300 upright)

(* {1 Fewer than it needs} *)

let has_bits = Sys.int_size >= 63

let leaves_of shapes =
  let bvh = Bvh.make shapes in
  Leaves.make shapes ~numbers:(Bvh.numbers bvh) ~balls:(Bvh.spheres bvh)

let test_limits () =
  let shapes = cloud 200 ~size:10. ~radius:(fun () -> 100.) in
  let leaves = leaves_of shapes in
  let is_made most source = Option.is_some (Fan.make leaves ~most source) in
  let lamp = Fan.Point Vec3.zero in
  (* each of the six sides sees all, in one cell at least *)
  Alcotest.(check bool) "enough" has_bits (is_made 1200 lamp);
  Alcotest.(check bool) "too few" false (is_made 1199 lamp);
  Alcotest.(check bool)
    "beyond numbers" false
    (is_made 10_000 (Point (Vec3.make 1e200 0. 0.)))

(* What is too small to be squared is in one cell, and not in ever more. *)
let test_tiny () =
  let shapes = cloud 30 ~size:1e-170 ~radius:(fun () -> 1e-171) in
  let sun = Fan.Along (Direction.of_vec3_exn (Vec3.make 1. (-2.) 1.5)) in
  Alcotest.(check bool)
    "made" has_bits
    (Option.is_some (Fan.make (leaves_of shapes) ~most:1000 sun));
  Alcotest.(check bool)
    "a grid, too" true
    (Option.is_some (Grid.make (leaves_of shapes)))

let suite =
  ( "Fan",
    [
      Alcotest.test_case "clouds" `Quick test_clouds;
      Alcotest.test_case "crowds" `Quick test_crowds;
      Alcotest.test_case "flat" `Quick test_flat;
      Alcotest.test_case "limits" `Quick test_limits;
      Alcotest.test_case "tiny" `Quick test_tiny;
      holds "as brute force" 500 (case QCheck2.Gen.(0 -- 80) Generate.everyday);
      holds "of many" 20 (case (QCheck2.Gen.pure 1500) Generate.everyday);
      holds ~law:is_as_without "with numbers of any size" 1000
        (case QCheck2.Gen.(0 -- 40) Generate.extreme);
    ] )
