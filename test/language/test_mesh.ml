(* Meshes in scenes, which here are in memory. What is in their files, and how
   they are met, ../mesh_file and ../geometry tell. *)

open Raylab_source
open Raylab_geometry
open Raylab_scene
open Raylab_language

let triangle = "v 0 0 4\nv 1 0 4\nv 0 1 4\nf 1 2 3\n"

let reading ?(main = "main.scene") ?(counts = Hashtbl.create 1) files =
  let find ~from name =
    let path = Access.join ~from name in
    if List.mem_assoc path files then
      (* as a link would lead to it *)
      let identity = if path = "link.obj" then "a.obj" else path in
      Ok { Access.path; identity }
    else Access.refuse "no such file"
  and read ~limit:_ { Access.path; _ } =
    Hashtbl.add counts path ();
    Ok (List.assoc path files)
  in
  let access = { Access.main = Some main; find; read } in
  let text = Read.with_header (List.assoc main files) in
  Loader.read access (Sources.make ~name:main text)

let parsed files =
  let { Loader.syntax; sources; _ } = reading files in
  Result.bind syntax (Evaluate.scene sources)

let objects files =
  match parsed files with
  | Ok scene -> scene.objects
  | Error errors -> Alcotest.fail (Read.show_errors errors)

let told { Scene_error.place; message; advice; _ } =
  let { Sources.line; first; last } = Option.get place in
  Printf.sprintf "%d:%d-%d: %s" line first last
    (String.concat "\n" (List.filter (( <> ) "") [ message; advice ]))

let check_error what expected files =
  match parsed files with
  | Ok _ -> Alcotest.failf "%s: no error" what
  | Error errors ->
      Alcotest.(check string)
        what expected
        (String.concat "\n" (List.map told errors))

let rec mesh : Shape.t -> Mesh.t = function
  | Mesh mesh -> mesh
  | Placed { own; _ } -> mesh own
  | _ -> Alcotest.fail "no mesh"

let test_smooth () =
  let check what expected text =
    match objects [ ("main.scene", text); ("a.obj", triangle) ] with
    | [ o ] ->
        Alcotest.(check bool) what expected (Mesh.is_smooth (mesh o.shape))
    | _ -> Alcotest.fail what
  in
  check "flat" false {|mesh "a.obj" reflective|};
  check "smooth" true {|mesh "a.obj" smooth reflective|};
  check "a surface called smooth" false
    {|let smooth = reflective mesh "a.obj" smooth|};
  check "a mesh with a name" true
    {|let bunny = mesh "a.obj" smooth reflective bunny|}

(* By whatever paths and from whatever files it is reached. *)
let test_once () =
  let counts = Hashtbl.create 7 in
  let files =
    [
      ( "main.scene",
        {|include "b.scene" for i = 1 to 3 mesh "a.obj" smooth reflective
          translated (i) 0 0 end mesh "link.obj" reflective scaled 2|}
      );
      ("b.scene", {|mesh "a.obj" reflective mesh "a.obj" smooth reflective|});
      ("a.obj", triangle);
      ("link.obj", triangle);
    ]
  in
  let { Loader.sources; named; _ } = reading ~counts files in
  Alcotest.(check int)
    "read once" 1
    (List.length (Hashtbl.find_all counts "a.obj"));
  Alcotest.(check (list string))
    "the files of the scene"
    [ "main.scene"; "b.scene"; "a.obj" ]
    (Sources.paths sources);
  Alcotest.(check (list string))
    "what the names stand for"
    [ "b.scene"; "a.obj"; "a.obj"; "a.obj"; "a.obj" ]
    (List.sort (fun a b -> String.compare b a) (List.map snd named));
  let meshes = List.map (fun (o : Object.t) -> mesh o.shape) (objects files) in
  let facets = List.map Mesh.facets meshes in
  let { Facets.points; _ } = List.hd facets in
  Alcotest.(check bool)
    "in memory once" true
    (List.for_all (fun (f : Facets.t) -> f.points == points) facets);
  let smooth = List.filter Mesh.is_smooth meshes in
  Alcotest.(check bool)
    "smooth ones, too" true
    (List.for_all (fun mesh -> mesh == List.hd smooth) smooth)

let test_errors () =
  let check what expected ?(file = triangle) text =
    check_error what expected [ ("main.scene", text); ("a.obj", file) ]
  in
  check "a broken file" ~file:"v 0 0 0\nf 1 2 3\n"
    {|2:6-12: 'a.obj' cannot be read: line 2: a face has point 2, but there are only 1|}
    {|mesh "a.obj" reflective|};
  check "no such file" {|2:6-12: 'b.obj' cannot be read: no such file|}
    {|mesh "b.obj" reflective|};
  check_error "no format"
    {|2:6-12: 'a.txt' cannot be read: its name does not say which format it has
the name of a file of a mesh ends in .obj, .ply or .stl|}
    [ ("main.scene", {|mesh "a.txt" reflective|}); ("a.txt", triangle) ];
  check "an open mesh in a solid"
    {|2:7-10: this mesh cannot be part of a union: it is not closed: face 1 (line 4 of a.obj) has an edge from (0, 0, 4) to (1, 0, 4) that no other face has
a mesh has an inside if each edge, by where it is, has exactly two faces|}
    {|union mesh "a.obj" reflective end|};
  check "all that are wrong"
    {|2:6-12: 'b.obj' cannot be read: no such file
2:30-36: 'c.obj' cannot be read: no such file|}
    {|mesh "b.obj" reflective mesh "c.obj" reflective|}

let test_warnings () =
  let { Loader.unused; _ } =
    reading
      [
        ("main.scene", {|mesh "a.obj" reflective mesh "a.obj" reflective|});
        ("a.obj", triangle ^ "usemtl brass\n");
      ]
  in
  Alcotest.(check (list string))
    "once"
    [ "a.obj, line 5: materials are not used" ]
    (List.map (fun { Warning.text; _ } -> text) unused)

let suite =
  ( "Mesh",
    [
      Alcotest.test_case "smooth" `Quick test_smooth;
      Alcotest.test_case "read once" `Quick test_once;
      Alcotest.test_case "errors" `Quick test_errors;
      Alcotest.test_case "warnings" `Quick test_warnings;
    ] )
