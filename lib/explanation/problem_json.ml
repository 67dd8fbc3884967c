open Raylab_source
open Raylab_language

let version = 1

let schema =
  {|{ "version": 1, "scenes": [SCENE, ...] }

SCENE   = { "scene": STRING,              its path, as it was given
            "problems": [PROBLEM, ...] }  in the order of the text

PROBLEM = { "severity": "error" or "warning",
            "file": STRING,               the path of the scene, or of a file
                                          that it includes
            "line": INT or null,          counted from 1; null: the whole file
            "columns": [INT, INT]         the first and the last byte in the
              or null,                    line, counted from 1
            "message": STRING,            what is wrong, in one line
            "remedy": STRING }            what to do; "" if there is no advice|}

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

let scene (path, problems) : Yojson.Safe.t =
  `Assoc
    [
      ("scene", text (Printable.text path));
      ("problems", `List (List.map problem problems));
    ]

let document scenes : Yojson.Safe.t =
  `Assoc
    [ ("version", `Int version); ("scenes", `List (List.map scene scenes)) ]
