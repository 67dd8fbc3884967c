open Raylab_source
open Raylab_expression

type t = {
  check : Check.t;
  mutable seen : (string * Span.t) list;
  mutable settings : Settings.t;
}

let start check = { check; seen = []; settings = Settings.none }

let tell_again header word word_span { Span.start; _ } =
  let findings = Check.findings header.check in
  let first = Files.place (Sources.table (Findings.sources findings)) start in
  Findings.error findings word_span
    (Printf.sprintf "%s is set a second time" word)
    ~advice:
      (Printf.sprintf "it is already set%s; remove one of them"
         (Option.fold first ~none:"" ~some:(fun place ->
              " in " ^ Place.to_string place)))

let set header scope { Syntax.word; word_span; change } frame =
  let first = List.assoc_opt word header.seen in
  (* a file may be included twice *)
  if first <> Some word_span then (
    let change =
      Evaluate_written.compile header.check scope word_span ~default:Fun.id
        change
    in
    Frame.need frame (Scope.size scope);
    header.settings <- change frame header.settings;
    match first with
    | Some first -> tell_again header word word_span first
    | None -> header.seen <- (word, word_span) :: header.seen)

let finish header stop =
  let { check; seen; settings } = header in
  Check_camera.tell (Check.findings check) ~seen ~stop;
  if not (Check.failed check) then
    Check_camera.tell_view (Check.findings check) ~seen settings

let settings header = header.settings
