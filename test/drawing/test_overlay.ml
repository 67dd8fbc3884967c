open Raylab_geometry
open Raylab_scene
open Raylab_tracer
open Raylab_drawing

let camera =
  Camera.make ~width:100 ~height:80 ~canvas_width:10. ~canvas_height:8.
    ~depth:5.

let vec = Vec3.make
let point = Alcotest.(pair (float 1e-6) (float 1e-6))

(* A mirror before the eye, a wall behind it, two lights. *)
let overlay ~first_row =
  let bulb position =
    Light.spherical ~intensity:1. ~color:Color.white ~position
  in
  let scene =
    Scene.make camera ~ray_depth:2
      ~lights:[ bulb (vec 0. 3. 5.); bulb (vec 0. 0. 30.) ]
      ~objects:
        [
          Object.make
            (Shape.plane ~point:(vec 0. 0. 10.) ~normal:(vec 0. 0. (-1.)))
            (Surface.mixed
               [
                 (1., Surface.diffusive Color.white); (1., Surface.reflective);
               ]);
          Object.make
            (Shape.sphere ~centre:(vec 0. 1.5 7.5) ~radius:0.2)
            (Surface.luminous Color.red);
        ]
  in
  let pixel = Explain.pixel (Prepared.make scene) ~x:50 ~y:40 in
  Overlay.make camera ~first_row
    (Path.of_rays scene.film [ Explain.centre pixel ])

let test_make () =
  let { Overlay.lines; hits; blocks } = overlay ~first_row:0 in
  let words = Ray_look.words Picture in
  Alcotest.(check (list string))
    "rays"
    [ "to a light, blocked"; "mirrored ray" ]
    (List.map (fun { Overlay.kind; _ } -> words kind) lines);
  Alcotest.(check (list point)) "the hit is the pixel" [ (50.5, 40.5) ] hits;
  Alcotest.(check int) "blocks" 1 (List.length blocks);
  Alcotest.(check (list string))
    "kinds"
    [ "mirrored ray"; "to a light, blocked" ]
    (List.map words (Overlay.kinds (overlay ~first_row:0)))

let test_rows () =
  let y overlay = snd (List.hd overlay.Overlay.hits) in
  Alcotest.(check (float 1e-9))
    "rows count from the first that is shown"
    (y (overlay ~first_row:0) -. 30.)
    (y (overlay ~first_row:30))

(* {1 In a window} *)

let window = { Rectangle.left = 0.; top = 0.; right = 100.; bottom = 80. }

let draw ?(place = Fun.id) overlay =
  Overlay.draw ~place window ~pixel:(50, 40) overlay

let lines drawing =
  List.filter_map
    (function Drawing.Line (pen, a, b) -> Some (pen, a, b) | _ -> None)
    drawing

let discs drawing =
  List.filter_map
    (function Drawing.Circle (_, centre, _) -> Some centre | _ -> None)
    drawing

(* Each with a rim: a ray, a cross of two and a ring of four lines, a disc. *)
let test_draw () =
  let one place =
    let line =
      { Overlay.kind = Lit; tint = Color.white; ends = ((50., 40.), place) }
    in
    { Overlay.lines = [ line ]; hits = []; blocks = [] }
  in
  let empty = { Overlay.lines = []; hits = []; blocks = [] } in
  let number overlay = List.length (draw overlay) in
  Alcotest.(check int) "the ring" 8 (number empty);
  Alcotest.(check int) "a line" 10 (number (one (60., 40.)));
  Alcotest.(check int) "a disc" 10 (number { empty with hits = [ (1., 1.) ] });
  Alcotest.(check int)
    "a cross" 12
    (number { empty with blocks = [ (1., 1.) ] });
  Alcotest.(check int)
    "outside" 8
    (number { empty with hits = [ (-1., 1.) ]; blocks = [ (1e9, 0.) ] });
  match lines (draw (one (200., 40.))) with
  | (rim, _, _) :: (pen, a, b) :: _ ->
      Alcotest.(check (float 0.)) "rim" 2. (rim.width -. pen.width);
      Alcotest.(check (pair point point))
        "up to the edge"
        ((50., 40.), (100., 40.))
        (a, b)
  | _ -> Alcotest.fail "no line"

let test_place () =
  let place (x, y) = ((2. *. x) -. 60., y) in
  let drawing = draw ~place (overlay ~first_row:0) in
  Alcotest.(check (list point))
    "the disc, and its rim"
    [ (41., 40.5); (41., 40.5) ]
    (discs drawing)

(* {1 The legend} *)

let test_legend () =
  let high = { window with bottom = 200. } in
  let legend window kinds =
    let text_size words = (float_of_int (String.length words), 10.) in
    Legend.in_corner ~text_size window kinds
  in
  let words =
    List.filter_map
      (function
        | Drawing.Text { words; place; _ } -> Some (words, place) | _ -> None)
      (legend high [ Path.Mirrored; Blocked ])
  in
  Alcotest.(check (list (pair string point)))
    "words"
    [ ("mirrored ray", (38., 168.)); ("to a light, blocked", (38., 181.)) ]
    words;
  let none what window kinds =
    Alcotest.(check int) what 0 (List.length (legend window kinds))
  in
  none "no kinds" high [];
  none "too low" { high with bottom = 150. } [ Mirrored; Lit; Blocked ];
  none "too narrow" { high with right = 40. } [ Mirrored ]

let suite =
  ( "Overlay",
    [
      Alcotest.test_case "of a path" `Quick test_make;
      Alcotest.test_case "a band of rows" `Quick test_rows;
      Alcotest.test_case "in a window" `Quick test_draw;
      Alcotest.test_case "scaled" `Quick test_place;
      Alcotest.test_case "legend" `Quick test_legend;
    ] )
