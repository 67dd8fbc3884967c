open Raylab_geometry
open Raylab_source

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
}

and parameter = { label : string; optional : bool }

and 'thing run = {
  budget : Budget.t;
  describe : 'thing -> string;
  mutable stack : 'thing frame list;
}

and 'thing frame =
  | Call of {
      name : string;
      arguments : (string * 'thing t) list;
      at : Span.t;
    }
  | Round of { name : string; value : 'thing t; at : Span.t }

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

let rec pp_with describe ppf = function
  | Number x -> Number.pp ppf x
  | Truth truth -> Format.pp_print_bool ppf truth
  | Text text -> Format.fprintf ppf "\"%s\"" text
  | Vector { x; y; z } ->
      Format.fprintf ppf "[%a, %a, %a]" Number.pp x Number.pp y Number.pp z
  | List elements -> pp_list describe ppf elements
  | Function { name; _ } -> Format.pp_print_string ppf name
  | (Thing _ | Undefined) as value ->
      Format.pp_print_string ppf (kind describe value)

and pp_list describe ppf elements =
  let count = Array.length elements in
  let shown = Array.sub elements 0 (Int.min count most_shown) in
  Format.pp_print_char ppf '[';
  Array.iteri
    (fun k element ->
      if k > 0 then Format.pp_print_string ppf ", ";
      pp_with describe ppf element)
    shown;
  if count > most_shown then Format.fprintf ppf ", ... %d in all" count;
  Format.pp_print_char ppf ']'

let to_string describe value =
  let text = Buffer.create 16 in
  let ppf = Format.formatter_of_buffer text in
  Format.fprintf ppf "%a@?" (pp_with describe) value;
  Buffer.contents text

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
