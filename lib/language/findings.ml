open Raylab_source
open Raylab_expression

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

let place sources offset =
  match Files.place (Sources.table sources) offset with
  | None -> ""
  | Some place -> Place.to_string place

let step sources (trail : Trail.t) =
  match trail with
  | Start -> ""
  | Call { name; arguments; at; _ } ->
      let argument (label, value) =
        Printf.sprintf "%s: %s" label (Datum.to_string value)
      in
      Printf.sprintf "in %s(%s), called in %s" name
        (String.concat ", " (List.map argument arguments))
        (place sources at)
  | Round { loop = { name; at }; value; _ } ->
      Printf.sprintf "with %s = %s, %s" name (Datum.to_string value)
        (place sources at)

let most_inner = 5
let most_outer = 3

(* Of a deep recursion both ends tell something. *)
let steps sources trail =
  let steps = Trail.apart trail ~from:Start in
  let count = List.length steps in
  let tell keep = List.map (step sources) (List.filteri keep steps) in
  if count <= most_inner + most_outer then tell (fun _ _ -> true)
  else
    let between = count - most_inner - most_outer in
    tell (fun k _ -> k < most_inner)
    @ [ Printf.sprintf "and %d more between these and" between ]
    @ tell (fun k _ -> k >= count - most_outer)

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
    let lines = steps findings.sources trail in
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
