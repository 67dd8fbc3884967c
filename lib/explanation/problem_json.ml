open Raylab_source
open Raylab_geometry
open Raylab_language

let version = 1

let schema =
  {|{ "version": 1, "scenes": [SCENE, ...] }

SCENE   = { "scene": STRING,              its path, as it was given
            "problems": [PROBLEM, ...],   in the order of the text
            "meshes": [MESH, ...] }       if it has some

PROBLEM = { "severity": "error" or "warning",
            "file": STRING,               the path of the scene, or of a file
                                          that it includes
            "line": INT or null,          counted from 1; null: the whole file
            "columns": [INT, INT]         the first and the last byte in the
              or null,                    line, counted from 1
            "message": STRING,            what is wrong, in one line
            "remedy": STRING }            what to do; "" if there is no advice

MESH    = { "file": STRING,               as explanations call it
            "triangles": INT,
            "low": VECTOR,                the corners of the box around it,
            "high": VECTOR,               each [x, y, z]
            "open": STRING or null,       where it is open; null: closed
            "normals": "outward", "inward", "anyhow", or a VECTOR, along
                                          which they point; of what is open
                                          most of them }|}

let text s : Yojson.Safe.t = `String s

let place : Sources.place option -> _ = function
  | None -> [ ("line", `Null); ("columns", `Null) ]
  | Some { line; first; last } ->
      [ ("line", `Int line); ("columns", `List [ `Int first; `Int last ]) ]

let severity : Problem.severity -> _ = function
  | Error -> text "error"
  | Warning -> text "warning"

let problem { Problem.severity = s; file; place = p; message; remedy } =
  `Assoc
    ((("severity", severity s) :: ("file", text file) :: place p)
    @ [ ("message", text message); ("remedy", text remedy) ])

let vector { Vec3.x; y; z } : Yojson.Safe.t =
  `List [ `Float x; `Float y; `Float z ]

let normals : Mesh_survey.normals -> Yojson.Safe.t = function
  | Outward -> text "outward"
  | Inward -> text "inward"
  | Anyhow -> text "anyhow"
  | Along direction -> vector (direction :> Vec3.t)

let mesh m =
  let { Mesh_survey.triangles; box; opening; normals = n } = Mesh_survey.make m
  and printable s = text (Printable.text s) in
  `Assoc
    [
      ("file", printable (Mesh.file m));
      ("triangles", `Int triangles);
      ("low", vector box.low);
      ("high", vector box.high);
      ("open", Option.fold ~none:`Null ~some:printable opening);
      ("normals", normals n);
    ]

type scene = { path : string; problems : Problem.t list; meshes : Mesh.t list }

let scene { path; problems; meshes } : Yojson.Safe.t =
  `Assoc
    ([
       ("scene", text (Printable.text path));
       ("problems", `List (List.map problem problems));
     ]
    @ if meshes = [] then [] else [ ("meshes", `List (List.map mesh meshes)) ]
    )

let document scenes : Yojson.Safe.t =
  `Assoc
    [ ("version", `Int version); ("scenes", `List (List.map scene scenes)) ]
