open Raylab_source

type parameter = {
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

let compile scope ~name parameters body =
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
  let parameters = Array.of_list (List.map parameter parameters) in
  fun outer ->
    let call run arguments =
      let slots = Array.make (Scope.size inner) Value.Undefined in
      Array.blit arguments 0 slots 0 (Array.length arguments);
      let frame = { Frame.slots; outer; run } in
      fill_in defaults frame;
      code frame
    in
    Value.Function { name; parameters; call }
