open Raylab_source

type parameter = Expression.parameter = {
  name : string;
  span : Span.t;
  default : Expression.t option;
}

let fill_in defaults (frame : _ Frame.t) =
  Array.iteri
    (fun k default ->
      match (frame.slots.(k), default) with
      | Value.Undefined, Some default -> frame.slots.(k) <- default frame
      | _ -> ())
    defaults

(* What a name is where a function is defined. *)
let around scope (outer : _ Frame.t) name =
  Option.map
    (fun (binding : Scope.binding) ->
      Frame.read binding ~levels:(Scope.level scope - binding.level) outer)
    (Scope.find scope name)

let compile scope ~name ?written parameters body =
  let bind (inner, bound) { name; span; default } =
    (* a default sees the parameters before it *)
    let default = Option.map (Code.compile inner) default in
    let inner, _ = Scope.bind inner name span in
    (inner, default :: bound)
  in
  let inner, defaults =
    List.fold_left bind (Scope.enter scope, []) parameters
  in
  let defaults = Array.of_list (List.rev defaults) in
  let code = body inner in
  let parameter { name; default; _ } =
    { Value.label = name; optional = Option.is_some default }
  in
  let all = parameters in
  let parameters = Array.of_list (List.map parameter parameters) in
  fun outer ->
    let call run arguments =
      let slots = Array.make (Scope.size inner) Value.Undefined in
      Array.blit arguments 0 slots 0 (Array.length arguments);
      let frame = { Frame.slots; outer; run } in
      fill_in defaults frame;
      code frame
    in
    let source =
      match written with
      | Some body ->
          Value.Written { parameters = all; body; around = around scope outer }
      | None -> Unwritten
    in
    Value.Function { name; parameters; call; source }
