type 'thing t = 'thing Frame.t -> 'thing Value.t

let constant value : _ t = fun _ -> value

let rec compile : 'thing. Scope.t -> Expression.t -> 'thing t =
 fun scope e ->
  match e.desc with
  | Number x -> constant (Number x)
  | Truth truth -> constant (Truth truth)
  | Text text -> constant (Text text)
  | Name name -> Name.compile scope name e.span ~calls:false
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
      fun frame -> Truth (not (code frame))
  | Binary (And, a, b) ->
      let a = truth scope a and b = truth scope b in
      fun frame -> Truth (a frame && b frame)
  | Binary (Or, a, b) ->
      let a = truth scope a and b = truth scope b in
      fun frame -> Truth (a frame || b frame)
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
        Frame.set binding frame (value frame);
        body frame
  | Word { arguments; _ } ->
      let argument (_, written) = compile scope written in
      let arguments = Array.of_list (List.map argument arguments) in
      fun frame ->
        Budget.step frame.run.budget e.span;
        let values = Array.map (fun code -> code frame) arguments in
        frame.run.make frame.run e values
  | Varying { name; name_span; body } ->
      let inner, binding = Scope.bind scope name name_span in
      let body = compile inner body in
      fun frame ->
        Frame.set binding frame (Vector frame.run.point);
        body frame

and number : 'thing. Scope.t -> Expression.t -> 'thing Frame.t -> float =
 fun scope e ->
  match e.desc with
  | Number x -> fun _ -> x
  | _ -> (
      let code = compile scope e in
      fun frame ->
        match code frame with
        | Number x -> x
        | value -> Operation.number frame.run e value)

and truth : 'thing. Scope.t -> Expression.t -> 'thing Frame.t -> bool =
 fun scope e ->
  let code = compile scope e in
  fun frame ->
    match code frame with
    | Truth truth -> truth
    | value -> Operation.truth frame.run e value

and compile_call : 'thing. _ -> _ -> _ -> _ -> _ -> 'thing t =
 fun scope e name name_span arguments ->
  let argument (a : Expression.argument) = (a, compile scope a.value) in
  let arguments = Arguments.make (List.map argument arguments) in
  match
    (Scope.find scope name, Builtin.find (String.lowercase_ascii name))
  with
  | None, Some f -> Call.of_builtin e f arguments
  | _ ->
      let callee = Name.compile scope name name_span ~calls:true in
      fun frame -> Call.of_value frame e name arguments (callee frame)

and compile_triple : 'thing. _ -> _ -> _ -> _ -> 'thing t =
 fun scope x y z ->
  let x = number scope x and y = number scope y and z = number scope z in
  fun frame ->
    let x = x frame in
    let y = y frame in
    let z = z frame in
    Vector { x; y; z }

and compile_list : 'thing. _ -> _ -> _ -> 'thing t =
 fun scope e elements ->
  let codes = Array.of_list (List.map (compile scope) elements) in
  let count = Array.length codes in
  fun frame ->
    Budget.steps frame.run.budget e.span count;
    if count <> 3 then Budget.make frame.run.budget e.span count;
    Value.list (Array.map (fun code -> code frame) codes)

and compile_part : 'thing. _ -> _ -> _ -> 'thing t =
 fun scope vector letter ->
  let code = compile scope vector in
  fun frame ->
    let { Raylab_geometry.Vec3.x; y; z } =
      Operation.vector frame.run vector (code frame)
    in
    Number (match letter with 'x' | 'r' -> x | 'y' | 'g' -> y | _ -> z)

and compile_series : 'thing. _ -> _ -> _ -> _ -> _ -> _ -> 'thing t =
 fun scope e name name_span range body ->
  let inner, each = loop scope ~at:e.span name name_span range in
  let body = compile inner body in
  fun frame ->
    let made = ref [] in
    each frame (fun () ->
        Budget.make frame.run.budget e.span 1;
        made := body frame :: !made);
    Value.list (Array.of_list (List.rev !made))

and loop :
    'thing. _ -> at:_ -> _ -> _ -> _ -> _ * ('thing Frame.t -> _ -> unit) =
 fun scope ~at:span name name_span range ->
  let range = compile_range scope range in
  let inner, binding = Scope.bind scope name name_span in
  let loop = { Trail.name; at = name_span.start } in
  ( inner,
    fun frame f ->
      let run = frame.run in
      let around = run.trail in
      Loop.each ~at:span range frame (fun value ->
          Frame.set binding frame value;
          let value = Value.datum run.describe value in
          run.trail <- Round { loop; value; around };
          f ());
      run.trail <- around )

and compile_range : 'thing. _ -> _ -> 'thing Loop.range =
 fun scope range ->
  match range with
  | In written -> In { list = compile scope written; written }
  | To { first; last; step } ->
      To
        {
          first = number scope first;
          last = number scope last;
          step = Option.fold ~none:(fun _ -> 1.) ~some:(number scope) step;
          step_of = Option.value ~default:last step;
        }
