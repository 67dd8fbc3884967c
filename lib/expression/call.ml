open Raylab_source

let nowhere = { Span.start = 0; stop = 0 }

let builtin (f : Builtin.t) =
  let parameters =
    Array.of_list
      (List.map (fun label -> { Value.label; optional = false }) f.parameters)
  in
  let call run arguments = Operation.builtin run nowhere f arguments in
  { Value.name = f.name; parameters; call; source = Built_in }

(* The arguments that are given, with the names of their parameters. *)
let pair describe parameters arguments =
  let given = ref [] in
  for k = Array.length arguments - 1 downto 0 do
    match arguments.(k) with
    | Value.Undefined -> ()
    | value ->
        let datum = Value.datum describe value in
        given := (parameters.(k).Value.label, datum) :: !given
  done;
  !given

let enter (run : _ Value.run) span (f : _ Value.func) arguments =
  Budget.step run.budget span;
  Budget.enter run.budget span;
  let around = run.trail in
  let arguments_told = pair run.describe f.parameters arguments in
  run.trail <-
    Call
      {
        name = f.name;
        arguments = arguments_told;
        at = span.Span.start;
        around;
      };
  let value = f.call run arguments in
  run.trail <- around;
  Budget.leave run.budget;
  value

let of_value (frame : _ Frame.t) (e : Expression.t) name arguments = function
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

let of_builtin (e : Expression.t) (f : Builtin.t) arguments =
  let { Value.parameters; _ } = builtin f in
  (* what is wrong with them is told where the call is evaluated *)
  match Arguments.arrange e.span ~name:f.name parameters arguments with
  | exception Fault.Found fault -> fun _ -> raise (Fault.Found fault)
  | given ->
      let given = Array.map Option.get given in
      fun (frame : _ Frame.t) ->
        Budget.step frame.run.budget e.span;
        let values = Array.map (fun code -> code frame) given in
        Operation.builtin frame.run e.span f values
