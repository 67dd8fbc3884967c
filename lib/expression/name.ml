let suggestion scope name ~calls =
  let functions = List.map (fun (f : Builtin.t) -> f.name) Builtin.all in
  let constants = List.map (fun (name, _, _) -> name) Builtin.constants in
  let among =
    Scope.names scope @ functions @ if calls then [] else constants
  in
  match Nearest.find name ~among with
  | Some known -> Printf.sprintf "Did you mean '%s'?" known
  | None -> ""

let unknown scope name span ~calls =
  let what = if calls then "function" else "name" in
  let advice =
    match Scope.hint scope name with
    | Some hint -> hint
    | None -> suggestion scope name ~calls
  in
  Scope.report_once scope name span ~advice
    (Printf.sprintf "unknown %s '%s'" what name);
  fun _ -> raise Fault.Known

let in_own_definition scope name span =
  Scope.report_once scope name span
    ~advice:
      "from its definition on a name stands for what it is defined as, and \
       not yet within the definition: choose another name"
    (Printf.sprintf "'%s' stands in its own definition" name);
  fun _ -> raise Fault.Known

let constant name =
  List.find_map
    (fun (other, value, _) -> if name = other then Some value else None)
    Builtin.constants

let compile scope name span ~calls =
  match Scope.find scope name with
  | Some binding when not binding.is_defined ->
      in_own_definition scope name span
  | Some binding ->
      Frame.read binding ~levels:(Scope.level scope - binding.level)
  | None -> (
      let key = String.lowercase_ascii name in
      match (Builtin.find key, constant key) with
      | Some f, _ ->
          let value = Value.Function (Call.builtin f) in
          fun _ -> value
      | None, Some x ->
          let value = Value.Number x in
          fun _ -> value
      | None, None -> unknown scope name span ~calls)
