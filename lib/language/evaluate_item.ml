open Raylab_expression

let add (frame : Check.frame) sink span node =
  Budget.make frame.run.budget span (Thing.size node).count;
  Sink.add sink frame.run span node

(* What a block repeats is not written each time. *)
let ready check ~at origin word node =
  let span =
    match Raylab_scene.Origin.offset origin with
    | Some start ->
        { Raylab_source.Span.start; stop = start + String.length word }
    | None -> at
  in
  Check.item check (fun (frame : Check.frame) sink ->
      Budget.make frame.run.budget at 1;
      Sink.add sink frame.run span (Thing.again frame.run.trail node))

let rec tell_twice check names (item : Syntax.item) =
  match item with
  | Include inclusion ->
      Twice.included names inclusion.span
        (Evaluate_include.compile compile check inclusion)
  | item -> Twice.item names item

and compile check scope ~at (item : Syntax.item) =
  match item with
  | Ready_object o ->
      let word = Raylab_geometry.Shape.name o.shape in
      (scope, ready check ~at o.origin word (Thing.leaf o))
  | Ready_light l ->
      let word = Raylab_scene.Light.name l in
      (scope, ready check ~at l.origin word (Thing.lamp l))
  | Placed placed -> (scope, place check scope placed)
  | Definition d ->
      let scope, define = Evaluate_definition.compile block check scope d in
      (scope, fun frame _ -> define frame)
  | Include inclusion ->
      let file = Evaluate_include.compile compile check inclusion in
      ( Evaluate_include.names scope file,
        fun _ sink ->
          file.define ();
          file.place sink )
  | For { name; name_span; range; body } ->
      let inner, each = Code.loop scope ~at:name_span name name_span range in
      let body = block check inner ~at:name_span body in
      ( scope,
        Check.item check (fun frame sink ->
            each frame (fun () -> body frame sink)) )
  | If { condition; yes; no } ->
      let test = Code.truth scope condition and at = condition.span in
      let yes = block check scope ~at yes and no = block check scope ~at no in
      ( scope,
        Check.item check (fun frame sink ->
            if test frame then yes frame sink else no frame sink) )

and place check scope placed =
  let thing = Evaluate_thing.compile block check scope placed in
  Check.item check (fun frame sink ->
      match thing frame with
      | Thing.Light { node; _ } | Object { node; _ } ->
          add frame sink placed.span node
      | Surface _ -> ())

and block check scope ~at items =
  let names = Twice.start check in
  let compile (scope, codes) item =
    tell_twice check names item;
    let scope, code = compile check scope ~at item in
    (scope, code :: codes)
  in
  let _, codes = List.fold_left compile (scope, []) items in
  let codes = Array.of_list (List.rev codes) in
  (* no Array.iter, which would be on the stack as well *)
  fun frame sink ->
    for k = 0 to Array.length codes - 1 do
      Budget.step frame.Frame.run.budget at;
      codes.(k) frame sink
    done
