open Raylab_source

type t = {
  check : Check.t;
  mutable seen : (string * Span.t) list;
  mutable settings : Settings.t;
}

let start check = { check; seen = []; settings = Settings.none }

let set header scope { Syntax.word; word_span; change } frame =
  let change =
    Evaluate_written.compile header.check scope word_span ~default:Fun.id
      change
  in
  header.settings <- change frame header.settings;
  match List.assoc_opt word header.seen with
  | Some first ->
      let findings = Check.findings header.check in
      let place = Sources.place (Findings.sources findings) first in
      Findings.error findings word_span
        (Printf.sprintf "%s is set a second time" word)
        ~advice:
          (Printf.sprintf "it is already set in line %d; remove one of them"
             place.line)
  | None -> header.seen <- (word, word_span) :: header.seen

let finish header stop =
  let { check; seen; settings } = header in
  Check_camera.tell (Check.findings check) ~seen ~stop;
  if not (Check.failed check) then
    Check_camera.tell_view (Check.findings check) ~seen settings

let settings header = header.settings
