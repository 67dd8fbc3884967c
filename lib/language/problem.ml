open Raylab_source
open Raylab_scene

type severity = Error | Warning

type t = {
  severity : severity;
  file : string;
  place : Sources.place option;
  message : string;
  remedy : string;
}

let of_error { Scene_error.file; place; message; advice; _ } =
  { severity = Error; file; place; message; remedy = advice }

(* The word that starts at an offset. *)
let word sources start =
  let { Sources.base; text; _ } = Sources.file sources start in
  let is_blank c = c <= ' ' || c = '#' in
  let rec stop at =
    if at < String.length text && not (is_blank text.[at]) then stop (at + 1)
    else at
  in
  { Span.start; stop = base + stop (start - base) }

let of_warning path reading ({ Warning.about; _ } as warning) =
  let { Scene_file.sources; _ } = reading in
  let message = Warning.to_string (Scene_file.provenance reading) warning in
  let problem file place =
    { severity = Warning; file; place; message; remedy = "" }
  in
  match List.find_map Origin.offset about with
  | Some offset ->
      let place = Sources.place sources (word sources offset) in
      problem (Sources.title sources offset) (Some place)
  | None -> problem (Printable.text path) None

let of_reading path reading =
  let errors =
    match reading.Scene_file.scene with Error errors -> errors | Ok _ -> []
  in
  List.map of_error errors
  @ List.map (of_warning path reading) (Scene_file.findings reading)
