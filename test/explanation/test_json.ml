open Raylab_geometry
open Raylab_expression
open Raylab_scene
open Raylab_tracer
open Raylab_explanation
open Test_support
open Build

let vector x y z = `List [ `Float x; `Float y; `Float z ]
let parse text = Yojson.Safe.from_string text

let pixel_is_same (pixel : Explain.pixel) (decoded : Decode.pixel) =
  decoded.rgb = Film.to_bytes pixel.film pixel.color
  && decoded.summary = Summary.of_pixel pixel
  && compare decoded.explanation pixel = 0

let parses_back scene =
  let pixels = Any.explained scene in
  let text = Json.to_string (Json.document pixels) in
  List.for_all2 pixel_is_same pixels (Decode.document (parse text))

let round_trip =
  Property.holds "parsed, it is the explanation" ~count:200
    ~print:(Property.show Scene.pp)
    (Generate.scene ~max_side:5 Generate.everyday) (fun scene ->
      parses_back (Prepared.make scene))

(* The strict printer refuses numbers that are not finite. *)
let strict =
  Any.holds "JSON whatever the numbers" (fun scene ->
      let json = Json.document (Any.explained scene) in
      compare (parse (Json.to_string json)) json = 0)

(* Neither ends a string early nor brings a control character with it. *)
let any_string =
  Property.holds "JSON whatever the text" ~print:String.escaped
    QCheck2.Gen.(string_size ~gen:(map Char.chr (int_bound 127)) (0 -- 20))
    (fun text ->
      let json = Json.to_string (`String text) in
      let is_plain c = c >= ' ' && c <> '\x7f' in
      String.for_all is_plain (String.trim json) && parse json = `String text)

(* {1 By hand} *)

let test_document () =
  let background = rgb 0.25 0.5 2. in
  let scene = Prepared.make (Scene.make ~background (camera ())) in
  let pixel = Explain.pixel scene ~x:0 ~y:0 in
  let color = `List [ `Float 0.25; `Float 0.5; `Float 2. ]
  and shown = `List [ `Float 0.25; `Float 0.5; `Float 1. ] in
  let ray =
    ( "ray",
      `Assoc
        [
          ("origin", vector 0. 0. (-1.));
          ("direction", vector 0. 0. 1.);
          ("reach", `Null);
          ("seed", `Float (Raylab_geometry.Ray.seed (Explain.centre pixel).ray));
          ("share", `Float 1.);
          ("left", `Int 4);
          ("color", color);
          ("outcome", `String "missed");
          ("hit", `Null);
          ( "terms",
            `List
              [ `Assoc [ ("source", `String "background"); ("color", color) ] ]
          );
        ] )
  in
  let expected : Yojson.Safe.t =
    `Assoc
      [
        ("version", `Int 3);
        ( "pixels",
          `List
            [
              `Assoc
                [
                  ("x", `Int 0);
                  ("y", `Int 0);
                  ("rgb", `List [ `Int 64; `Int 128; `Int 255 ]);
                  ("summary", `String (Summary.of_pixel pixel));
                  ("color", shown);
                  ( "film",
                    `Assoc
                      [
                        ("samples", `Int 1);
                        ("exposure", `Float 1.);
                        ("srgb", `Bool false);
                      ] );
                  ("cause", `Null);
                  ("samples", `List [ `Assoc [ ("color", shown); ray ] ]);
                ];
            ] );
      ]
  in
  let found = parse (Json.to_string (Json.document [ pixel ])) in
  Alcotest.(check string)
    "as documented"
    (Yojson.Safe.to_string expected)
    (Yojson.Safe.to_string found)

(* What a program made, with all that an origin may say. *)
let test_made () =
  let around =
    Trail.Round
      { loop = { name = "i"; at = 11 }; value = Number 4.; around = Start }
  in
  let arguments =
    [
      ("n", Datum.Number 2.);
      ("flat", Truth true);
      ("name", Text "a");
      ("at", Vector (v 1. 2. 3.));
      ("all", List { first = [ Number 1. ]; count = 5 });
      ("of", Other "a surface");
    ]
  in
  let within = Trail.Call { name = "flake"; arguments; at = 99; around }
  and placed =
    Origin.By_name
      { name = "ball"; at = 106; within = Start; around = At_once }
  in
  let origin = Origin.Placed { at = 8; within; placed } in
  let shape = Shape.sphere ~centre:(v 0. 0. 6.) ~radius:1. in
  let object_ = Object.make ~origin shape Surface.reflective in
  let scene =
    Prepared.make (Scene.make ~files ~objects:[ object_ ] (camera ()))
  in
  let json = Json.document [ Explain.pixel scene ~x:0 ~y:0 ] in
  let first = function `List (first :: _) -> first | _ -> `Null in
  let pixel = first (Decode_scene.member "pixels" json) in
  let sample = first (Decode_scene.member "samples" pixel) in
  let made =
    List.fold_left
      (fun json name -> Decode_scene.member name json)
      sample
      [ "ray"; "hit"; "object"; "made" ]
  in
  Alcotest.(check string)
    "as documented"
    {|[{"call":"flake","arguments":[{"name":"n","value":2.0},{"name":"flat","value":true},{"name":"name","value":"a"},{"name":"at","value":[1.0,2.0,3.0]},{"name":"all","value":{"count":5,"first":[1.0]}},{"name":"of","value":{"what":"a surface"}}],"line":100},{"round":"i","value":4.0,"line":12},{"placed":"ball","line":7,"file":"wood.scene"}]|}
    (Yojson.Safe.to_string made)

(* Every kind of surface, light and verdict, and lines of two files. *)
let test_all_kinds () =
  let some = Surface.diffusive (rgb 0.1 0.2 0.3) in
  let mix =
    Surface.mixed
      [
        (0.1, Surface.reflective);
        (0.2, Surface.luminous Color.red);
        (1. /. 3., some);
      ]
  in
  let lights =
    [
      Light.with_origin (at_line 3)
        (Light.spherical ~intensity:0.7 ~color:Color.cyan
           ~position:(v 0. 1. (-1.)));
      Light.directional ~intensity:1. ~color:Color.white
        ~direction:(v 0.3 1. 0.7);
      Light.with_origin (at_line_of_wood 4)
        (Light.directional ~intensity:1. ~color:Color.white
           ~direction:(v 0. 1. (-1.)));
      Light.spot ~intensity:1. ~color:Color.white
        (Beam.make_exn ~position:(v 0. 1. (-1.)) ~target:(v 0. 9. 0.) ~inner:1.
           ~outer:2.);
      Light.unfading
        (Light.area ~intensity:1. ~color:Color.white
           (Pane.make ~corner:(v 0. 1. (-1.)) ~edge:(v 1. 0. 0.)
              ~other:(v 0. 1. 0.) ~count:2));
    ]
  in
  let objects =
    [
      plane ~line:7 (v 0. 0. 4.) (v 0.1 0. 1.) mix;
      Object.make ~origin:(at_line_of_wood 8)
        (Shape.sphere ~centre:(v 0. (-3.) 1.) ~radius:1.5)
        some;
      sphere (v 0.4 0. (-6.)) 1.5 Surface.reflective;
    ]
  in
  let scene =
    Prepared.make
      (Scene.make ~ambient:(rgb 0.1 0.2 0.3) ~lights ~objects ~files
         (camera ()))
  in
  let e = Explain.centre (Explain.pixel scene ~x:0 ~y:0) in
  let verdicts =
    match e.outcome with
    | Hit { lights; _ } ->
        List.map
          (fun { Explain.verdict; _ } ->
            match verdict with
            | Lit _ -> "lit"
            | Blocked _ -> "blocked"
            | Faces_away _ -> "away"
            | Outside _ -> "outside"
            | Mean _ -> "mean")
          lights
    | _ -> []
  in
  Alcotest.(check (list string))
    "all verdicts"
    [ "lit"; "blocked"; "away"; "outside"; "mean" ]
    verdicts;
  Alcotest.(check bool) "parses back" true (parses_back scene)

(* An object is its words and their parts, by name. *)
let test_object () =
  let ball = sphere (v 0. 0. 6.) 1. (Surface.luminous Color.red) in
  let scene = Prepared.make (Scene.make ~objects:[ ball ] (camera ())) in
  let json = Json.of_ray (Explain.centre (Explain.pixel scene ~x:0 ~y:0)) in
  Expect.contains "sphere"
    ~part:
      ({|"shape":{"kind":"sphere","centre":[0.0,0.0,6.0],"radius":1.0},|}
     ^ {|"surface":{"kind":"luminous","color":[1.0,0.0,0.0]}|})
    (Yojson.Safe.to_string json)

let suite =
  ( "Json",
    Alcotest.test_case "document" `Quick test_document
    :: Alcotest.test_case "made" `Quick test_made
    :: Alcotest.test_case "all kinds" `Quick test_all_kinds
    :: Alcotest.test_case "an object" `Quick test_object
    :: round_trip :: any_string :: strict )
