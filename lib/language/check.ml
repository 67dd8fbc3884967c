open Raylab_expression

type frame = Thing.t Frame.t
type 'a ready = frame -> 'a

type t = {
  findings : Findings.t;
  outermost : Scope.t * frame;
  files : (int, File_code.t) Hashtbl.t;
  mutable failed : bool;
}

let start findings scope frame =
  {
    findings;
    outermost = (scope, frame);
    files = Hashtbl.create 7;
    failed = false;
  }

let outermost check = check.outermost

let file check base compile =
  match Hashtbl.find_opt check.files base with
  | Some file -> file
  | None ->
      let file = compile () in
      Hashtbl.add check.files base file;
      file

let findings check = check.findings
let failed check = check.failed

let fail check (run : _ Value.run) trail depth =
  run.trail <- trail;
  run.budget.depth <- depth;
  check.failed <- true

let attempt check (frame : frame) default f =
  let run = frame.run in
  let trail = run.trail and depth = run.budget.depth in
  match f () with
  | value -> value
  | exception Fault.Found ({ ends = false; _ } as fault) ->
      Findings.fault check.findings fault run.trail;
      fail check run trail depth;
      default
  | exception Fault.Known ->
      fail check run trail depth;
      default

let whole check build =
  let whole frame =
    let before = check.failed in
    check.failed <- false;
    match build frame with
    | built ->
        let failed = check.failed in
        check.failed <- before;
        if failed then raise_notrace Fault.Known else built
    | exception e ->
        check.failed <- before;
        raise e
  in
  whole

let item check code =
  let item (frame : frame) sink =
    let run = frame.run in
    let trail = run.trail and depth = run.budget.depth in
    let before = check.failed in
    check.failed <- false;
    match code frame sink with
    | () ->
        if check.failed then fail check run trail depth
        else check.failed <- before
    | exception Fault.Found ({ ends = false; _ } as fault) ->
        Findings.fault check.findings fault run.trail;
        fail check run trail depth
    | exception Fault.Known -> fail check run trail depth
  in
  item
