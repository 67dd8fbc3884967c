open Raylab_geometry
open Raylab_source

type 'thing value =
  | Number of float
  | Truth of bool
  | Text of string
  | Vector of Vec3.t
  | List of 'thing value array
  | Function of string
  | Thing of 'thing

type 'thing definition =
  | Value of 'thing value
  | Defined of { parameters : Expression.parameter list; body : Expression.t }

type 'thing t = {
  name : string;
  body : Expression.t;
  definitions : (string * 'thing definition) list;
}

let key = String.lowercase_ascii

(* {1 Making} *)

(* A name as it was written, what it is called here, and what it stands for. *)
type 'a known = { written : string; called : string; value : 'a Value.t }

type ('a, 'thing) state = {
  reserved : string -> bool;
  thing : 'a -> 'thing option;
  run : 'a Value.run;
  at : Span.t;
  mutable known : 'a known list;
  mutable defined : (string * 'thing definition) list; (* the last one first *)
}

let same (a : _ Value.t) (b : _ Value.t) =
  match (a, b) with
  | Function f, Function g -> f == g
  | Number x, Number y -> x = y && Float.sign_bit x = Float.sign_bit y
  | _ -> a == b

let is_built_in name =
  Option.is_some (Builtin.find name)
  || List.exists (fun (constant, _, _) -> constant = name) Builtin.constants

(* A name that is not taken, nor introduced by [bound]. *)
let fresh state ~bound written =
  let is_free name =
    let name = key name in
    not
      (state.reserved name || is_built_in name || List.mem name bound
      || List.exists (fun { called; _ } -> key called = name) state.known)
  in
  let numbered n = Printf.sprintf "%s_%d" written n in
  let rec from n = if is_free (numbered n) then numbered n else from (n + 1) in
  if is_free written then written else from 2

let refuse state what =
  Fault.fail state.at (Printf.sprintf "%s cannot be used in a pattern" what)

(* What a name that is bound elsewhere is called here. *)
let rec called state ~bound around name =
  match around name with
  | None -> name
  | Some value -> (
      let is_it known =
        key known.written = key name
        && same known.value value
        && not
             (List.mem (key known.called) bound && key known.called <> key name)
      in
      match List.find_opt is_it state.known with
      | Some { called; _ } -> called
      | None -> define state ~bound name value)

and define state ~bound name value =
  (* the name itself may be introduced within, where it is another one *)
  let bound = List.filter (fun other -> other <> key name) bound in
  let called = fresh state ~bound name in
  state.known <- { written = name; called; value } :: state.known;
  let definition =
    match value with
    | Function ({ source = Written _ | Unwritten; _ } as f) ->
        function_ state f
    | value -> Value (constant state value)
  in
  state.defined <- (called, definition) :: state.defined;
  called

and function_ state (f : _ Value.func) =
  match f.source with
  | Written { parameters; body; around } ->
      let bound = Names.bound parameters body in
      let free = called state ~bound around in
      let binder = binder state ~bound in
      let parameters, body =
        Names.map_function ~binder ~free parameters body
      in
      Defined { parameters; body }
  | Built_in -> Value (Function f.name)
  | Unwritten -> refuse state (f.name ^ ", which makes objects,")

and constant state (value : _ Value.t) =
  match value with
  | Number x -> Number x
  | Truth truth -> Truth truth
  | Text text -> Text text
  | Vector v -> Vector v
  | List elements ->
      Budget.make state.run.budget state.at (Array.length elements);
      List (Array.map (constant state) elements)
  | Function { source = Built_in; name; _ } -> Function name
  | Function f ->
      let around _ = Some value in
      Function (called state ~bound:[] around f.name)
  | Thing thing -> (
      match state.thing thing with
      | Some thing -> Thing thing
      | None -> refuse state (state.run.describe thing))
  | Undefined -> raise Fault.Known

and binder state ~bound name =
  if state.reserved (key name) then fresh state ~bound name else name

let make ~reserved ~thing ~run ~around ~at name body =
  let state = { reserved; thing; run; at; known = []; defined = [] } in
  let bound = key name :: Names.bound [] body in
  let binder = binder state ~bound in
  let point = binder name in
  let free other =
    if key other = key name then point else called state ~bound around other
  in
  let body = Names.map ~binder ~free body in
  { name = point; body; definitions = List.rev state.defined }

(* {1 Reading} *)

let rec add_things found = function
  | Thing thing -> thing :: found
  | List elements -> Array.fold_left add_things found elements
  | Number _ | Truth _ | Text _ | Vector _ | Function _ -> found

let things_where holds { definitions; _ } =
  let add found = function
    | _, Value value when holds value -> add_things found value
    | _ -> found
  in
  List.rev (List.fold_left add [] definitions)

let things closed = things_where (fun _ -> true) closed

let listed closed =
  things_where (function List _ -> true | _ -> false) closed

let rec map_value f = function
  | Thing thing -> Thing (f thing)
  | List elements -> List (Array.map (map_value f) elements)
  | (Number _ | Truth _ | Text _ | Vector _ | Function _) as same -> same

let map f { name; body; definitions } =
  let definition = function
    | name, Value value -> (name, Value (map_value f value))
    | name, Defined d -> (name, Defined d)
  in
  { name; body; definitions = List.map definition definitions }

let rec equal_value equal_things a b =
  match (a, b) with
  | Thing a, Thing b -> equal_things a b
  | List a, List b ->
      Array.length a = Array.length b
      && Array.for_all2 (equal_value equal_things) a b
  | (Number _ | Truth _ | Text _ | Vector _ | Function _), _ -> a = b
  | (Thing _ | List _), _ -> false

let same_body a b = Names.without_places a = Names.without_places b

let same_parameter (a : Expression.parameter) (b : Expression.parameter) =
  key a.name = key b.name && Option.equal same_body a.default b.default

let equal_definition equal_things (name, a) (name', b) =
  key name = key name'
  &&
  match (a, b) with
  | Value a, Value b -> equal_value equal_things a b
  | Defined a, Defined b ->
      List.equal same_parameter a.parameters b.parameters
      && same_body a.body b.body
  | (Value _ | Defined _), _ -> false

let equal equal_things a b =
  key a.name = key b.name
  && same_body a.body b.body
  && List.equal (equal_definition equal_things) a.definitions b.definitions

(* {1 Evaluation} *)

type 'thing code = {
  size : int;
  set : ('thing Frame.t -> unit) list; (* what puts each name into a frame *)
  point : Scope.binding;
  evaluate : 'thing Code.t;
}

let nowhere = { Span.start = 0; stop = 0 }

(* All names are known. *)
let report _ ~advice:_ message = invalid_arg ("Closed.compile: " ^ message)

let rec of_constant scope = function
  | Number x -> Value.Number x
  | Truth truth -> Truth truth
  | Text text -> Text text
  | Vector v -> Vector v
  | List elements -> List (Array.map (of_constant scope) elements)
  | Thing thing -> Thing thing
  | Function name -> (
      match Builtin.find (key name) with
      | Some f -> Function (Call.builtin f)
      | None -> Undefined)

let rec refers_to_functions = function
  | Function name -> not (is_built_in (key name))
  | List elements -> Array.exists refers_to_functions elements
  | Number _ | Truth _ | Text _ | Vector _ | Thing _ -> false

(* The same with functions that are in the frame. *)
let rec of_frame scope frame = function
  | Function name when not (is_built_in (key name)) ->
      Name.compile scope name nowhere ~calls:false frame
  | List elements -> List (Array.map (of_frame scope frame) elements)
  | value -> of_constant scope value

let compile_definition (scope, set) (name, definition) =
  let inner, binding = Scope.bind scope name nowhere in
  let code =
    match definition with
    | Value value when refers_to_functions value ->
        fun frame -> of_frame scope frame value
    | Value value ->
        let value = of_constant scope value in
        fun _ -> value
    | Defined { parameters; body } ->
        Function.compile inner ~name ~written:body parameters (fun scope ->
            Code.compile scope body)
  in
  (inner, (fun frame -> Frame.set binding frame (code frame)) :: set)

let compile { name; body; definitions } =
  let start = (Scope.start report, []) in
  let scope, set = List.fold_left compile_definition start definitions in
  let inner, point = Scope.bind scope name nowhere in
  let evaluate = Code.compile inner body in
  { size = Scope.size inner; set = List.rev set; point; evaluate }

type 'thing machine = {
  frame : 'thing Frame.t;
  point : Scope.binding;
  evaluate : 'thing Code.t;
}

let start ~describe ~make { size; set; point; evaluate } =
  let budget = Budget.start ~steps:Budget.pattern_steps in
  let run =
    { Value.budget; describe; make; trail = Start; point = Vec3.zero }
  in
  let frame = Frame.start run ~size in
  List.iter (fun set -> set frame) set;
  { frame; point; evaluate }

let value { frame; point = binding; evaluate } point =
  let run = frame.run in
  Budget.restart run.budget;
  run.trail <- Start;
  run.point <- point;
  Frame.set binding frame (Vector point);
  evaluate frame

let trail { frame; _ } = frame.run.trail
let run { frame; _ } = frame.run
