open Raylab_source
open Raylab_expression

let nowhere = { Span.start = 0; stop = 0 }

let start findings budget time =
  let run =
    {
      Value.budget;
      describe = Thing.describe;
      make = (fun _ _ _ -> invalid_arg "Evaluate: a surface in an expression");
      trail = Start;
      point = Raylab_geometry.Vec3.zero;
    }
  in
  let report span ~advice message =
    Findings.error findings span message ~advice
  in
  let scope, binding =
    Scope.bind (Scope.start report ~hint:Habit.of_name) "time" nowhere
  in
  let frame = Frame.start run ~size:8 in
  Frame.set binding frame (Number time);
  (scope, frame)

let run_header check scope frame header sink names items =
  let run scope (item : Syntax.header_item) =
    match item with
    | Setting setting ->
        Check_header.set header scope setting frame;
        scope
    | Header_definition d ->
        Twice.item names (Definition d);
        let scope, define =
          Evaluate_definition.compile Evaluate_item.block check scope d
        in
        Frame.need frame (Scope.size scope);
        define frame;
        scope
    | Header_include inclusion ->
        let file =
          Evaluate_include.compile Evaluate_item.compile check inclusion
        in
        Twice.included names inclusion.span file;
        file.define ();
        let set (scope, setting) =
          Check_header.set header scope setting frame
        in
        List.iter set file.settings;
        file.place sink;
        Evaluate_include.names scope file
  in
  List.fold_left run scope items

(* One item after the other, so that nothing is kept of those that are done. *)
let run_items check scope frame sink names items =
  let run scope (item : Syntax.item) =
    match item with
    | Ready_object o ->
        Sink.add sink frame.Frame.run nowhere (Thing.leaf o);
        scope
    | Ready_light l ->
        Sink.add sink frame.Frame.run nowhere (Thing.lamp l);
        scope
    | item ->
        Evaluate_item.tell_twice check names item;
        let scope, code = Evaluate_item.compile check scope ~at:nowhere item in
        Frame.need frame (Scope.size scope);
        code frame sink;
        scope
  in
  ignore (List.fold_left run scope items : Scope.t)

let scene ?(time = 0.) ?(budget = Budget.scene ()) sources (syntax : Syntax.t)
    =
  let findings = Findings.start sources in
  let scope, frame = start findings budget time in
  let check = Check.start findings scope frame in
  let header = Check_header.start check and names = Twice.start check in
  let sink = Sink.scene () in
  (try
     let scope =
       run_header check scope frame header sink names syntax.header
     in
     Check_header.finish header syntax.header_end;
     run_items check scope frame sink names syntax.items
   with Fault.Found fault -> Findings.fault findings fault frame.run.trail);
  match Findings.errors findings with
  | [] ->
      Ok
        (Settings.scene
           (Check_header.settings header)
           ~files:(Sources.table sources) ~lights:(Sink.lights sink)
           ~objects:(Sink.objects sink))
  | errors -> Error errors
