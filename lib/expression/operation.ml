open Raylab_geometry

let show (run : _ Value.run) = Value.to_string run.describe
let kind (run : _ Value.run) = Value.kind run.describe

(* The expression, and what it is if that is not the same. *)
let wanted run (e : Expression.t) what value =
  let found =
    match (value : _ Value.t) with
    | Thing _ | Function _ | List _ | Undefined -> kind run value
    | _ -> Printf.sprintf "%s, %s" (kind run value) (show run value)
  in
  Fault.fail e.span
    (Printf.sprintf "%s should stand here, and %s is %s" what
       (Expression.to_string e) found)

let number run e = function
  | Value.Number x -> x
  | value -> wanted run e "a number" value

let truth run e = function
  | Value.Truth truth -> truth
  | value -> wanted run e "a condition (true or false)" value

let vector run e = function
  | Value.Vector v -> v
  | value -> wanted run e "a vector" value

let elements run e value =
  match Value.elements value with
  | Some elements -> elements
  | None -> wanted run e "a list" value

(* {1 Operators} *)

let not_finite run (e : Expression.t) symbol a b =
  Fault.fail e.span
    (Printf.sprintf "%s is not a finite number: it is %s %s %s"
       (Expression.to_string e) (show run a) symbol (show run b))

let map2 f (u : Vec3.t) (v : Vec3.t) =
  Vec3.make (f u.x v.x) (f u.y v.y) (f u.z v.z)

let map f (v : Vec3.t) = Vec3.make (f v.x) (f v.y) (f v.z)

let misfit run (e : Expression.t) symbol a b =
  Fault.fail e.span
    (Printf.sprintf "%s has no value: %s %s %s" (Expression.to_string e)
       (kind run a) symbol (kind run b))

let arithmetic : Expression.operator -> float -> float -> float = function
  | Add -> ( +. )
  | Subtract -> ( -. )
  | Multiply -> ( *. )
  | Divide -> ( /. )
  | _ -> Power.pow

(* Where numbers and vectors may meet. *)
let mixes : Expression.operator -> [ `Left | `Right ] -> bool = function
  | Multiply -> fun _ -> true
  | Divide -> fun vector -> vector = `Left
  | _ -> fun _ -> false

let calculate run e operator a b =
  let symbol = Expression.symbol operator in
  let finite v =
    if Vec3.is_finite v then Value.Vector v else not_finite run e symbol a b
  in
  match (a, b) with
  | Value.Number x, Value.Number y ->
      let z =
        match operator with
        | Add -> x +. y
        | Subtract -> x -. y
        | Multiply -> x *. y
        | Divide -> x /. y
        | _ -> Power.pow x y
      in
      if Float.is_finite z then Value.Number z else not_finite run e symbol a b
  | Vector u, Vector v when operator <> Power ->
      finite (map2 (arithmetic operator) u v)
  | Number x, Vector v when mixes operator `Right ->
      finite (map (arithmetic operator x) v)
  | Vector u, Number y when mixes operator `Left ->
      finite (map (fun x -> arithmetic operator x y) u)
  | _ -> misfit run e symbol a b

let compare run e operator a b =
  match (a, b, (operator : Expression.operator)) with
  | Value.Number x, Value.Number y, Less -> x < y
  | Number x, Number y, Less_or_equal -> x <= y
  | Number x, Number y, Greater -> x > y
  | Number x, Number y, _ -> x >= y
  | _ -> misfit run e (Expression.symbol operator) a b

let equal (run : _ Value.run) (e : Expression.t) operator a b =
  let step () = Budget.step run.budget e.span in
  match Value.equal ~step a b with
  | Some same -> same
  | None -> misfit run e (Expression.symbol operator) a b

let binary run e operator a b =
  match (operator : Expression.operator) with
  | Add | Subtract | Multiply | Divide | Power -> calculate run e operator a b
  | Equal -> Value.Truth (equal run e operator a b)
  | Different -> Truth (not (equal run e operator a b))
  | Less | Less_or_equal | Greater | Greater_or_equal ->
      Truth (compare run e operator a b)
  | And | Or -> misfit run e (Expression.symbol operator) a b

let negative run e = function
  | Value.Number x -> Value.Number (-.x)
  | Vector v -> Vector (Vec3.neg v)
  | value -> wanted run e "a number or a vector" value

(* {1 Built-in functions} *)

let shown_call run (f : Builtin.t) arguments =
  Printf.sprintf "%s(%s)" f.name
    (String.concat ", " (List.map (show run) (Array.to_list arguments)))

let element run span f arguments elements i =
  let count = Array.length elements in
  if Float.is_integer i && i >= 0. && i < float_of_int count then
    elements.(int_of_float i)
  else
    Fault.fail span
      (Printf.sprintf "%s has no value: the list has %d elements"
         (shown_call run f arguments)
         count)
      ~advice:"elements are counted from 0"

let misused run span (f : Builtin.t) arguments =
  Fault.fail span
    (Printf.sprintf "%s has no value" (shown_call run f arguments))
    ~advice:(Printf.sprintf "%s is %s" (Builtin.usage f) f.doc)

let builtin run span (f : Builtin.t) arguments =
  let not_finite () =
    Fault.fail span
      (Printf.sprintf "%s is not a finite number" (shown_call run f arguments))
  in
  let number x = if Float.is_finite x then Value.Number x else not_finite ()
  and vector v = if Vec3.is_finite v then Value.Vector v else not_finite () in
  match (f.body, arguments) with
  | Number f, [| Value.Number x |] -> number (f x)
  | Number_2 f, [| Number x; Number y |] -> number (f x y)
  | Number_3 f, [| Number x; Number y; Number z |] -> number (f x y z)
  | Of_vector f, [| Vector v |] -> number (f v)
  | Of_vectors f, [| Vector u; Vector v |] -> number (f u v)
  | Vector f, [| Vector v |] -> vector (f v)
  | Vectors f, [| Vector u; Vector v |] -> vector (f u v)
  | To_vector f, [| Number x; Number y; Number z |] -> vector (f x y z)
  | Vector_number f, [| Vector v; Number x |] -> number (f v x)
  | Mix, [| Number a; Number b; Number t |] -> number (Range.mix a b t)
  | Mix, [| Vector a; Vector b; Number t |] ->
      vector (map2 (fun a b -> Range.mix a b t) a b)
  | Count, [| list |] -> (
      match Value.elements list with
      | Some elements -> number (float_of_int (Array.length elements))
      | None -> misused run span f arguments)
  | Nth, [| list; Number i |] -> (
      match Value.elements list with
      | Some elements -> element run span f arguments elements i
      | None -> misused run span f arguments)
  | _ -> misused run span f arguments
