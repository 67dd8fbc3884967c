open Raylab_source
open Raylab_expression

type item =
  Check.t ->
  Scope.t ->
  at:Span.t ->
  Syntax.item ->
  Scope.t * (Check.frame -> Sink.t -> unit)

let names scope { File_code.names; _ } =
  let add scope (name, binding) = Scope.add scope name binding in
  List.fold_left add scope names

(* What is built up while a file is compiled, the last of each first. *)
type parts = {
  scope : Scope.t;
  defines : (unit -> unit) list;
  settings : (Scope.t * Syntax.setting) list;
  places : (is_first:bool -> Sink.t -> unit) list;
}

let include_ twice span file parts =
  Twice.included twice span file;
  {
    scope = names parts.scope file;
    defines = file.File_code.define :: parts.defines;
    settings = List.rev_append file.settings parts.settings;
    places = (fun ~is_first:_ sink -> file.place sink) :: parts.places;
  }

(* What is written once is not computed: it counts from the second time on. *)
let literal frame at node ~is_first sink =
  let run = frame.Frame.run in
  if not is_first then Budget.make run.budget at (Thing.size node).count;
  Sink.add sink run at (Thing.again run.trail node)

let once f =
  let is_done = ref false in
  fun () ->
    if not !is_done then (
      is_done := true;
      f ())

let ready (frame : Check.frame) at names parts =
  let defines = List.rev parts.defines
  and places = List.rev parts.places
  and placed = ref false in
  let define () =
    let around = frame.run.trail in
    frame.run.trail <- Start;
    List.iter (fun define -> define ()) defines;
    frame.run.trail <- around
  and place sink =
    let is_first = not !placed in
    placed := true;
    let place code =
      Budget.step frame.run.budget at;
      code ~is_first sink
    in
    List.iter place places
  in
  let settings = List.rev parts.settings in
  { File_code.names; define = once define; settings; place }

let rec compile item check { Syntax.file; span } =
  Check.file check file.base (fun () -> compile_file item check file span)

and compile_file item check { Syntax.names; syntax; _ } at =
  let scope, frame = Check.outermost check and twice = Twice.start check in
  let included parts inclusion =
    include_ twice inclusion.Syntax.span (compile item check inclusion) parts
  and add parts written =
    let scope, code = item check parts.scope ~at written in
    let place ~is_first:_ sink = code frame sink in
    { parts with scope; places = place :: parts.places }
  and define parts definition =
    let written = Syntax.Definition definition in
    Twice.item twice written;
    let scope, code = item check parts.scope ~at written in
    let define () = code frame (Sink.grouping Together) in
    { parts with scope; defines = define :: parts.defines }
  in
  let header parts (written : Syntax.header_item) =
    match written with
    | Setting setting ->
        { parts with settings = (parts.scope, setting) :: parts.settings }
    | Header_definition definition -> define parts definition
    | Header_include inclusion -> included parts inclusion
  and rest parts (written : Syntax.item) =
    match written with
    | Definition definition -> define parts definition
    | Include inclusion -> included parts inclusion
    | Ready_object o ->
        { parts with places = literal frame at (Thing.leaf o) :: parts.places }
    | Ready_light l ->
        { parts with places = literal frame at (Thing.lamp l) :: parts.places }
    | Placed _ | For _ | If _ -> add parts written
  in
  let parts = { scope; defines = []; settings = []; places = [] } in
  let parts = List.fold_left header parts syntax.header in
  let header_settings = parts.settings in
  let parts = List.fold_left rest parts syntax.items in
  Frame.need frame (Scope.size parts.scope);
  let name name =
    Option.map (fun binding -> (name, binding)) (Scope.find parts.scope name)
  in
  ready frame at
    (List.filter_map name names)
    { parts with settings = header_settings }
