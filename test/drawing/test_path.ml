open Raylab_scene
open Raylab_tracer
open Raylab_drawing
open Test_support
open Build

let bulb x y z =
  Light.spherical ~intensity:9. ~color:Color.white ~position:(v x y z)

let sun x y z =
  Light.directional ~intensity:1. ~color:Color.white ~direction:(v x y z)

let white = Surface.diffusive Color.white

(* A wall lit by a bulb and not by the sun, which a ball is in the way of, and a
   mirror before it. *)
let scene =
  Scene.make
    ~lights:[ bulb 0. 2. (-1.); sun 0. (-1.) (-1.) ]
    ~objects:
      [
        plane (v 0. 0. 4.) (v 0. 0. 1.) Surface.reflective;
        plane (v 0. 0. (-9.)) (v 0. 0. 1.) white;
        sphere (v 0. 3. (-6.)) 1. white;
      ]
    (camera ())

let path_of scene =
  let pixel = Explain.pixel (Prepared.make scene) ~x:0 ~y:0 in
  Path.of_rays scene.film [ Explain.centre pixel ]

let kind : Path.kind -> string = function
  | Primary -> "primary"
  | Mirrored -> "mirrored"
  | Refracted -> "refracted"
  | Unfollowed -> "unfollowed"
  | Lit -> "lit"
  | Blocked -> "blocked"

let test_lines () =
  let path = path_of scene in
  let show (ray : Path.ray) =
    let at = Option.get (Path.end_of ray) in
    let met = Option.value ray.meets ~default:0 in
    Format.asprintf "%d, %s to %d at (%.3f, %.3f, %.3f)" ray.number
      (kind ray.kind) met (at.x +. 0.) (at.y +. 0.) (at.z +. 0.)
  in
  Alcotest.(check (list string))
    "rays"
    [
      "1, primary to 1 at (0.000, 0.000, 4.000)";
      "2, mirrored to 2 at (0.000, 0.000, -9.000)";
      "2, lit to 0 at (0.000, 2.000, -1.000)";
      "2, blocked to 3 at (0.000, 2.293, -6.707)";
    ]
    (List.map show path.rays);
  Alcotest.(check (list (pair (option int) string)))
    "lights, and words"
    [
      (None, "to plane 1, t = 5");
      (None, "to plane 2, t = 13");
      (Some 1, "to light 1");
      (Some 2, "blocked by sphere 3");
    ]
    (List.map (fun (ray : Path.ray) -> (ray.light, ray.words)) path.rays);
  Alcotest.(check (list int)) "objects" [ 1; 2; 3 ] (Path.objects path);
  Alcotest.(check (list int))
    "hits" [ 1; 2 ]
    (List.map (fun (hit : Path.hit) -> hit.number) path.hits)

let words path = List.map (fun (ray : Path.ray) -> ray.words) path.Path.rays

let test_endless () =
  let floor = plane (v 0. 0. 4.) (v 0. 1. (-1.)) in
  let path surface lights =
    path_of
      (Scene.make ~ray_depth:1 ~lights ~objects:[ floor surface ] (camera ()))
  in
  let lit = path white [ sun 0. (-1.) 0. ] in
  Alcotest.(check string) "the sun" "light 1" (List.nth (words lit) 1);
  let mirrored = path Surface.reflective [] in
  Alcotest.(check string)
    "a chain that ends" "the chain has ended"
    (List.nth (words mirrored) 1);
  Alcotest.(check (list string))
    "nothing is hit" [ "to the background" ]
    (words (path_of (Scene.make (camera ()))));
  Alcotest.(check bool)
    "no end" true
    (List.for_all
       (fun ray -> Path.end_of ray = None)
       (List.tl lit.rays @ List.tl mirrored.rays))

(* Two mirrors that face each other. *)
let test_long () =
  let depth = 20_000 in
  let mirror z = plane (v 0. 0. z) (v 0. 0. 1.) Surface.reflective in
  let path =
    path_of
      (Scene.make ~ray_depth:depth
         ~objects:[ mirror 4.; mirror (-9.) ]
         (camera ()))
  in
  Alcotest.(check int) "hits" depth (List.length path.hits);
  let last = List.nth path.rays depth in
  Alcotest.(check int) "number" (depth + 1) last.number;
  Alcotest.(check string) "kind" "unfollowed" (kind last.kind)

let suite =
  ( "Path",
    [
      Alcotest.test_case "rays and hits" `Quick test_lines;
      Alcotest.test_case "rays without end" `Quick test_endless;
      Alcotest.test_case "a long chain" `Quick test_long;
    ] )
