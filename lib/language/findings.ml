open Raylab_source
open Raylab_expression
open Raylab_scene

type t = {
  sources : Sources.t;
  mutable found : (Span.t * Scene_error.t) list;
  mutable count : int;
  mutable first_untold : Span.t option;
  faults : (Span.t * string, unit) Hashtbl.t;
}

let start sources =
  {
    sources;
    found = [];
    count = 0;
    first_untold = None;
    faults = Hashtbl.create 7;
  }

let sources findings = findings.sources

(* Nobody reads more of them, and those of a hostile file would fill memory. *)
let most = 100_000

let error findings span ?advice message =
  findings.count <- findings.count + 1;
  if findings.count <= most then
    let error = Scene_error.make findings.sources span ?advice message in
    findings.found <- (span, error) :: findings.found
  else if findings.first_untold = None then findings.first_untold <- Some span

let longest_message = 300

(* Values may have any text in them, and be long. *)
let told text =
  let text = Printable.text text in
  if String.length text <= longest_message then text
  else Printable.text (String.sub text 0 longest_message) ^ "..."

let fault findings { Fault.span; message; advice; _ } trail =
  (* one mistake is not told of each round *)
  let place = (span, match trail with Trail.Start -> message | _ -> "") in
  if not (Hashtbl.mem findings.faults place) then (
    Hashtbl.add findings.faults place ();
    let lines = Steps.tell (Sources.table findings.sources) trail in
    let lines = if advice = "" then lines else lines @ [ advice ] in
    error findings span (told message)
      ~advice:(String.concat "\n" (List.map told lines)))

let untold findings =
  let tell span =
    let more = findings.count - most in
    Scene_error.make findings.sources span
      (Printf.sprintf "%d more error%s, the first of them here" more
         (if more = 1 then "" else "s"))
  in
  Option.to_list (Option.map tell findings.first_untold)

let errors findings =
  let by_start (a, _) (b, _) = Int.compare a.Span.start b.Span.start in
  List.map snd (List.stable_sort by_start (List.rev findings.found))
  @ untold findings
