open Raylab_source

type 'thing frame = {
  mutable slots : 'thing Value.t array;
  outer : 'thing frame;
  run : 'thing Value.run;
}

type 'thing t = 'thing frame -> 'thing Value.t

let start run ~size =
  let rec frame =
    { slots = Array.make size Value.Undefined; outer = frame; run }
  in
  frame

let need frame size =
  let present = Array.length frame.slots in
  if size > present then
    let more = Array.make (Int.max 8 (size + present)) Value.Undefined in
    frame.slots <- Array.append frame.slots more

let rec up frame levels =
  if levels = 0 then frame else up frame.outer (levels - 1)

(* Names are bound in the innermost function only. *)
let set (binding : Scope.binding) frame value =
  if binding.slot >= Array.length frame.slots then need frame (binding.slot + 1);
  frame.slots.(binding.slot) <- value

(* {1 Names} *)

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
  Scope.report_once scope name span
    ~advice:(suggestion scope name ~calls)
    (Printf.sprintf "unknown %s '%s'" what name);
  fun _ -> raise Fault.Known

let read (binding : Scope.binding) levels =
  let slot = binding.slot in
  let read frame =
    match frame.slots.(slot) with
    | Value.Undefined -> raise Fault.Known
    | value -> value
  in
  match levels with
  | 0 -> fun frame -> read frame
  | 1 -> fun frame -> read frame.outer
  | levels -> fun frame -> read (up frame levels)

let in_own_definition scope name span =
  Scope.report_once scope name span
    ~advice:
      "from its definition on a name stands for what it is defined as, and \
       not yet within the definition: choose another name"
    (Printf.sprintf "'%s' stands in its own definition" name);
  fun _ -> raise Fault.Known

let builtin_value (f : Builtin.t) =
  let parameters =
    Array.of_list
      (List.map (fun label -> { Value.label; optional = false }) f.parameters)
  in
  let nowhere = { Span.start = 0; stop = 0 } in
  let call run arguments = Operation.builtin run nowhere f arguments in
  { Value.name = f.name; parameters; call }

let constant name =
  List.find_map
    (fun (other, value, _) -> if name = other then Some value else None)
    Builtin.constants

let compile_name scope name span ~calls : 'thing t =
  match Scope.find scope name with
  | Some binding when not binding.is_defined ->
      in_own_definition scope name span
  | Some binding -> read binding (Scope.level scope - binding.level)
  | None -> (
      let key = String.lowercase_ascii name in
      match (Builtin.find key, constant key) with
      | Some f, _ ->
          let value = Value.Function (builtin_value f) in
          fun _ -> value
      | None, Some x ->
          let value = Value.Number x in
          fun _ -> value
      | None, None -> unknown scope name span ~calls)

(* {1 Calls} *)

let pair parameters arguments =
  let given = ref [] in
  for k = Array.length arguments - 1 downto 0 do
    match arguments.(k) with
    | Value.Undefined -> ()
    | value -> given := (parameters.(k).Value.label, value) :: !given
  done;
  !given

let enter (run : _ Value.run) span (f : _ Value.func) arguments =
  Budget.step run.budget span;
  Budget.enter run.budget span;
  let around = run.stack in
  run.stack <-
    Call { name = f.name; arguments = pair f.parameters arguments; at = span }
    :: around;
  let value = f.call run arguments in
  run.stack <- around;
  Budget.leave run.budget;
  value

let call_value frame (e : Expression.t) name arguments = function
  | Value.Function f ->
      let given = Arguments.arrange e.span ~name f.parameters arguments in
      let evaluate = function
        | Some code -> code frame
        | None -> Value.Undefined
      in
      enter frame.run e.span f (Array.map evaluate given)
  | value ->
      Fault.fail e.span
        (Printf.sprintf "%s is %s, not a function" name
           (Value.kind frame.run.describe value))

let call_builtin (e : Expression.t) (f : Builtin.t) arguments =
  let { Value.parameters; _ } = builtin_value f in
  let given =
    lazy
      (Arguments.arrange e.span ~name:f.name parameters arguments
      |> Array.map Option.get)
  in
  fun frame ->
    Budget.step frame.run.budget e.span;
    let values = Array.map (fun code -> code frame) (Lazy.force given) in
    Operation.builtin frame.run e.span f values

(* {1 Expressions} *)

let rec compile : 'thing. Scope.t -> Expression.t -> 'thing t =
 fun scope e ->
  match e.desc with
  | Number x ->
      let value = Value.Number x in
      fun _ -> value
  | Truth truth ->
      let value = Value.Truth truth in
      fun _ -> value
  | Text text ->
      let value = Value.Text text in
      fun _ -> value
  | Name name -> compile_name scope name e.span ~calls:false
  | Call { name; name_span; arguments } ->
      compile_call scope e name name_span arguments
  | Triple (x, y, z) -> compile_triple scope x y z
  | List elements -> compile_list scope e elements
  | Series { name; name_span; range; body } ->
      compile_series scope e name name_span range body
  | Part (vector, letter) -> compile_part scope vector letter
  | Negative operand ->
      let code = compile scope operand in
      fun frame ->
        Budget.step frame.run.budget e.span;
        Operation.negative frame.run operand (code frame)
  | Not operand ->
      let code = truth scope operand in
      fun frame -> Value.Truth (not (code frame))
  | Binary (And, a, b) ->
      let a = truth scope a and b = truth scope b in
      fun frame -> Value.Truth (a frame && b frame)
  | Binary (Or, a, b) ->
      let a = truth scope a and b = truth scope b in
      fun frame -> Value.Truth (a frame || b frame)
  | Binary (operator, a, b) ->
      let a = compile scope a and b = compile scope b in
      fun frame ->
        Budget.step frame.run.budget e.span;
        let a = a frame in
        let b = b frame in
        Operation.binary frame.run e operator a b
  | If (condition, a, b) ->
      let condition = truth scope condition in
      let a = compile scope a and b = compile scope b in
      fun frame -> if condition frame then a frame else b frame
  | Let { name; name_span; value; body } ->
      let value = compile scope value in
      let inner, binding = Scope.bind scope name name_span in
      let body = compile inner body in
      fun frame ->
        set binding frame (value frame);
        body frame

and number : 'thing. Scope.t -> Expression.t -> 'thing frame -> float =
 fun scope e ->
  match e.desc with
  | Number x -> fun _ -> x
  | _ -> (
      let code = compile scope e in
      fun frame ->
        match code frame with
        | Value.Number x -> x
        | value -> Operation.number frame.run e value)

and truth : 'thing. Scope.t -> Expression.t -> 'thing frame -> bool =
 fun scope e ->
  let code = compile scope e in
  fun frame ->
    match code frame with
    | Value.Truth truth -> truth
    | value -> Operation.truth frame.run e value

and compile_call : 'thing. _ -> _ -> _ -> _ -> _ -> 'thing t =
 fun scope e name name_span arguments ->
  let argument (a : Expression.argument) = (a, compile scope a.value) in
  let arguments = Arguments.make (List.map argument arguments) in
  match
    (Scope.find scope name, Builtin.find (String.lowercase_ascii name))
  with
  | None, Some f -> call_builtin e f arguments
  | _ ->
      let callee = compile_name scope name name_span ~calls:true in
      fun frame -> call_value frame e name arguments (callee frame)

and compile_triple : 'thing. _ -> _ -> _ -> _ -> 'thing t =
 fun scope x y z ->
  let x = number scope x and y = number scope y and z = number scope z in
  fun frame ->
    let x = x frame in
    let y = y frame in
    let z = z frame in
    Value.Vector { x; y; z }

and compile_list : 'thing. _ -> _ -> _ -> 'thing t =
 fun scope e elements ->
  let codes = Array.of_list (List.map (compile scope) elements) in
  let count = Array.length codes in
  fun frame ->
    Budget.steps frame.run.budget e.span count;
    if count <> 3 then Budget.make frame.run.budget e.span count;
    Value.list (Array.map (fun code -> code frame) codes)

and compile_series : 'thing. _ -> _ -> _ -> _ -> _ -> _ -> 'thing t =
 fun scope e name name_span range body ->
  let each = rounds scope e.span range in
  let inner, binding = Scope.bind scope name name_span in
  let body = compile inner body in
  fun frame ->
    let run = frame.run in
    let around = run.stack and made = ref [] and count = ref 0 in
    each frame (fun value ->
        set binding frame value;
        run.stack <- Round { name; value; at = name_span } :: around;
        Budget.make run.budget e.span 1;
        made := body frame :: !made;
        incr count);
    run.stack <- around;
    Value.list (Array.of_list (List.rev !made))

and compile_part : 'thing. _ -> _ -> _ -> 'thing t =
 fun scope vector letter ->
  let code = compile scope vector in
  fun frame ->
    let { Raylab_geometry.Vec3.x; y; z } =
      Operation.vector frame.run vector (code frame)
    in
    Value.Number (match letter with 'x' | 'r' -> x | 'y' | 'g' -> y | _ -> z)

and rounds :
    'thing.
    Scope.t ->
    Span.t ->
    Expression.range ->
    'thing frame ->
    ('thing Value.t -> unit) ->
    unit =
 fun scope span range ->
  match range with
  | In list ->
      let code = compile scope list in
      fun frame f ->
        let each value =
          Budget.step frame.run.budget span;
          f value
        in
        Array.iter each (Operation.elements frame.run list (code frame))
  | To { first; last; step } ->
      let first = number scope first and last_at = last in
      let last = number scope last in
      let step_at = Option.value ~default:last_at step in
      let step = Option.fold ~none:(fun _ -> 1.) ~some:(number scope) step in
      fun frame f ->
        let first = first frame in
        let last = last frame in
        let step = step frame in
        let count = Rounds.count ~step_of:step_at ~first ~last ~step in
        let k = ref 0. in
        while !k < count do
          Budget.step frame.run.budget span;
          f (Value.Number (Rounds.value ~first ~step !k));
          k := !k +. 1.
        done

(* {1 Functions} *)

type parameter = {
  name : string;
  span : Span.t;
  default : Expression.t option;
}

let func scope ~name parameters body =
  let bind (inner, bound) { name; span; default } =
    (* a default sees the parameters before it *)
    let default = Option.map (compile inner) default in
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
      let frame = { slots; outer; run } in
      Array.iteri
        (fun k default ->
          match (slots.(k), default) with
          | Value.Undefined, Some default -> slots.(k) <- default frame
          | _ -> ())
        defaults;
      code frame
    in
    Value.Function { name; parameters; call }
