open Raylab_scene
open Raylab_tracer
open Raylab_language
open Raylab_drawing
open Test_support

(* {1 What an SVG file shows}

   Read from the file, and with a measure of letters of its own: in the widest
   of the usual fonts, DejaVu Sans, a digit takes 0.64 of the size, and a word
   less than 0.6 a letter. *)

type text = { words : string; box : Rectangle.t }

let parts_after mark text =
  match Str.split_delim (Str.regexp_string mark) text with
  | _ :: parts -> parts
  | [] -> []

let until mark text = List.hd (Str.split_delim (Str.regexp_string mark) text)

let read_rectangle part =
  Scanf.sscanf part "%f\" y=\"%f\" width=\"%f\" height=\"%f\""
    (fun left top width height ->
      { Rectangle.left; top; right = left +. width; bottom = top +. height })

let read_text part =
  Scanf.sscanf part
    "%f\" y=\"%f\" font-size=\"%f\" text-anchor=\"%[a-z]\" %[^>]>%[^<]"
    (fun x y size anchor _ words ->
      let letters = float_of_int (String.length words) in
      let letter = if letters < 4. then 0.65 else 0.6 in
      let width = letter *. size *. letters in
      let left =
        match anchor with
        | "start" -> x
        | "middle" -> x -. (width /. 2.)
        | _ -> x -. width
      in
      let box =
        {
          Rectangle.left;
          right = left +. width;
          top = y -. (0.75 *. size);
          bottom = y +. (0.2 *. size);
        }
      in
      { words; box })

(* The panels of a file, each with its labels. *)
let panels svg =
  List.map
    (fun part ->
      let panel = read_rectangle (List.hd (parts_after "<rect x=\"" part)) in
      let texts = parts_after "<text x=\"" (until "</g>" part) in
      (panel, List.map read_text texts))
    (parts_after "<clipPath " svg)

let rec pairs = function
  | [] -> []
  | first :: rest -> List.map (fun other -> (first, other)) rest @ pairs rest

(* What is wrong with the labels of a file. *)
let faults svg =
  List.concat_map
    (fun (panel, texts) ->
      List.filter_map
        (fun { words; box } ->
          if Rectangle.holds panel box then None
          else Some (words ^ " is cut off"))
        texts
      @ List.filter_map
          (fun (a, b) ->
            if Rectangle.overlap a.box b.box then
              Some (Printf.sprintf "%s and %s overlap" a.words b.words)
            else None)
          (pairs texts))
    (panels svg)

let words (_, texts) = List.map (fun text -> text.words) texts

(* {1 Room} *)

let panel = { Rectangle.left = 0.; top = 0.; right = 200.; bottom = 100. }

let test_room () =
  let label ?reach places = Label.make ?reach places "light 1" in
  let here = label [ (50., 50.) ] in
  let count labels = List.length (Label.arrange panel ~busy:[] labels)
  and stands ?(busy = []) labels place =
    List.mem (Drawing.text place "light 1") (Label.arrange panel ~busy labels)
  in
  let check what expected result =
    Alcotest.(check bool) what expected result
  in
  let busy = [ Label.box here (50., 50.) ] in
  check "alone" true (stands [ here ] (50., 50.));
  check "the first of two" true (stands [ here; here ] (50., 50.));
  Alcotest.(check int) "and the second" 2 (count [ here; here ]);
  check "another place" true
    (stands [ here; label [ (50., 50.); (50., 90.) ] ] (50., 90.));
  Alcotest.(check int)
    "no room" 1
    (count [ here; label ~reach:0. [ (50., 50.) ] ]);
  check "not where it is busy" false (stands ~busy [ here ] (50., 50.));
  check "if there is a choice" true
    (stands ~busy [ label ~reach:0. [ (50., 50.) ] ] (50., 50.));
  check "the edge" true
    (let box = Label.box here (0., 0.) in
     stands [ label [ (-99., 999.) ] ] (-.box.left, 100. -. box.bottom))

(* {1 The gallery} *)

let directory = "../../scenes"

let load name =
  match
    Scene_file.load ~access:Test_files.Nearby.access
      (Filename.concat directory name)
  with
  | Ok scene -> scene
  | Error _ -> Alcotest.failf "%s is in error" name

let svg scene prepared (x, y) =
  Path_picture.to_svg scene (Explain.pixel prepared ~x ~y)

let drawn name pixel =
  let scene = load name in
  svg scene (Prepared.make scene) pixel

let across = 9
let down = 7

let some_pixels (scene : Scene.t) =
  let { Camera.width; height; _ } = scene.camera in
  let pixel k =
    ( width * ((2 * (k mod across)) + 1) / (2 * across),
      height * ((2 * (k / across)) + 1) / (2 * down) )
  in
  List.init (across * down) pixel

let test_gallery () =
  let scenes =
    List.filter
      (fun name -> Filename.check_suffix name ".scene")
      (Array.to_list (Sys.readdir directory))
  in
  Alcotest.(check bool) "scenes" true (List.length scenes > 10);
  List.iter
    (fun name ->
      let scene = load name in
      let prepared = Prepared.make scene in
      List.iter
        (fun ((x, y) as pixel) ->
          let svg = svg scene prepared pixel in
          Alcotest.(check (list string))
            (Printf.sprintf "%s %d,%d" name x y)
            [] (faults svg);
          List.iter
            (fun panel ->
              let has word =
                Alcotest.(check bool)
                  (Printf.sprintf "%s %d,%d: %s" name x y word)
                  true
                  (List.mem word (words panel))
              in
              List.iter has [ "eye"; "canvas" ])
            (panels svg))
        (some_pixels scene))
    scenes

(* Of these pixels no label is left out. *)
let test_all_there () =
  let check name pixel labels =
    List.iter
      (fun panel ->
        List.iter
          (fun label ->
            Alcotest.(check bool)
              (name ^ ": " ^ label)
              true
              (List.mem label (words panel)))
          labels)
      (panels (drawn (name ^ ".scene") pixel))
  in
  check "sphereflake" (5, 5)
    [
      "eye";
      "canvas";
      "light 1";
      "light 2";
      "light 3";
      "1";
      "to the background";
    ];
  check "facing-mirrors" (430, 300)
    ([
       "eye"; "canvas"; "light 1"; "light 2"; "plane 1"; "plane 2"; "sphere 26";
     ]
    @ List.init 25 (fun k -> string_of_int (k + 1)))

let any_scene =
  Any.holds "no overlap" ~count:60 ~max_side:4 (fun scene ->
      List.for_all
        (fun pixel ->
          faults (Path_picture.to_svg scene.Prepared.scene pixel) = [])
        (Any.explained scene))

let suite =
  ( "Labels",
    [
      Alcotest.test_case "room" `Quick test_room;
      Alcotest.test_case "the gallery" `Quick test_gallery;
      Alcotest.test_case "nothing is left out" `Quick test_all_there;
    ]
    @ any_scene )
