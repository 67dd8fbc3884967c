open Raylab_geometry

type t = {
  source : Source.t;
  mutable found : (Span.t * Scene_error.t) list;
  mutable count : int;
  mutable first_untold : Span.t option;
}

let start source = { source; found = []; count = 0; first_untold = None }
let source findings = findings.source

(* More help nobody, and a hostile file has as many as would fill memory. *)
let most = 100_000

let error findings span ?advice message =
  findings.count <- findings.count + 1;
  if findings.count <= most then
    let error = Scene_error.make findings.source span ?advice message in
    findings.found <- (span, error) :: findings.found
  else if findings.first_untold = None then findings.first_untold <- Some span

let check_value findings rule name span value =
  match Number.broken rule value with
  | None -> ()
  | Some problem ->
      let found = Source.quote findings.source span in
      error findings span (Printf.sprintf "%s %s, not %s" name problem found)

let untold findings =
  let tell span =
    let more = findings.count - most in
    Scene_error.make findings.source span
      (Printf.sprintf "%d more error%s, the first of them here" more
         (if more = 1 then "" else "s"))
  in
  Option.to_list (Option.map tell findings.first_untold)

let errors findings =
  let by_start (a, _) (b, _) = Int.compare (Span.start a) (Span.start b) in
  List.map snd (List.stable_sort by_start (List.rev findings.found))
  @ untold findings
