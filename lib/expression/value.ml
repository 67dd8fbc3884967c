open Raylab_geometry

type 'thing t =
  | Number of float
  | Truth of bool
  | Text of string
  | Vector of Vec3.t
  | List of 'thing t array
  | Function of 'thing func
  | Thing of 'thing
  | Undefined

and 'thing func = {
  name : string;
  parameters : parameter array;
  call : 'thing run -> 'thing t array -> 'thing t;
  source : 'thing source;
}

and 'thing source =
  | Built_in
  | Written of {
      parameters : Expression.parameter list;
      body : Expression.t;
      around : string -> 'thing t option;
    }
  | Unwritten

and parameter = { label : string; optional : bool }

and 'thing run = {
  budget : Budget.t;
  describe : 'thing -> string;
  make : 'thing run -> Expression.t -> 'thing t array -> 'thing t;
  mutable trail : Trail.t;
  mutable point : Vec3.t;
}

let list = function
  | [| Number x; Number y; Number z |] -> Vector (Vec3.make x y z)
  | elements -> List elements

let elements = function
  | Vector { x; y; z } -> Some [| Number x; Number y; Number z |]
  | List elements -> Some elements
  | _ -> None

let kind describe = function
  | Number _ -> "a number"
  | Truth _ -> "a truth value"
  | Text _ -> "a text"
  | Vector _ -> "a vector"
  | List elements -> Printf.sprintf "a list of %d" (Array.length elements)
  | Function _ -> "a function"
  | Thing thing -> describe thing
  | Undefined -> "nothing"

let most_shown = 4

(* Lists in lists may be shared, and far too many to be told. *)
let deepest_shown = 2

let rec shown describe depth = function
  | Number x -> Datum.Number x
  | Truth truth -> Truth truth
  | Text text -> Text text
  | Vector v -> Vector v
  | List elements when depth < deepest_shown ->
      let count = Array.length elements in
      let first = Array.sub elements 0 (Int.min count most_shown) in
      let shown element = shown describe (depth + 1) element in
      List { first = List.map shown (Array.to_list first); count }
  | Function { name; _ } -> Other name
  | (List _ | Thing _ | Undefined) as value -> Other (kind describe value)

let datum describe value = shown describe 0 value
let to_string describe value = Datum.to_string (datum describe value)

let rec equal ~step a b =
  step ();
  match (a, b) with
  | Number x, Number y -> Some (x = y)
  | Truth x, Truth y -> Some (Bool.equal x y)
  | Text x, Text y -> Some (String.equal x y)
  | Vector u, Vector v -> Some (Vec3.equal u v)
  | List a, List b -> equal_lists ~step a b
  | (Vector _ | List _), (Vector _ | List _) -> Some false
  | _ -> None

and equal_lists ~step a b =
  let rec from k =
    if k = Array.length a then Some true
    else
      match equal ~step a.(k) b.(k) with
      | Some true -> from (k + 1)
      | other -> other
  in
  if Array.length a <> Array.length b then Some false else from 0
