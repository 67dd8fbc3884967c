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

let attempt check (frame : frame) default f =
  let run = frame.run in
  let around = run.trail and depth = run.budget.depth in
  let fail () =
    run.trail <- around;
    run.budget.depth <- depth;
    check.failed <- true;
    default
  in
  match f () with
  | value -> value
  | exception Fault.Found ({ ends = false; _ } as fault) ->
      Findings.fault check.findings fault run.trail;
      fail ()
  | exception Fault.Known -> fail ()

let whole check build =
  let before = check.failed in
  check.failed <- false;
  match build () with
  | built ->
      let failed = check.failed in
      check.failed <- before;
      if failed then raise_notrace Fault.Known else built
  | exception e ->
      check.failed <- before;
      raise e
