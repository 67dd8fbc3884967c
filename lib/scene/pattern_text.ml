open Raylab_geometry
open Raylab_expression

let print_number ppf x = Format.pp_print_string ppf (Number.to_exact_string x)

(* In brackets. *)
let rec pp_element name_of ppf : Surface.t Closed.value -> unit = function
  | Number x -> print_number ppf x
  | Truth truth -> Format.pp_print_bool ppf truth
  | Text text -> Format.fprintf ppf "\"%s\"" text
  | Vector { x; y; z } ->
      Format.fprintf ppf "[%a, %a, %a]" print_number x print_number y
        print_number z
  | List elements ->
      let pp_sep ppf () = Format.pp_print_string ppf ", " in
      Format.fprintf ppf "[%a]"
        (Format.pp_print_list ~pp_sep (pp_element name_of))
        (Array.to_list elements)
  | Function name -> Format.pp_print_string ppf name
  | Thing surface ->
      Format.pp_print_string ppf
        (Option.value (name_of surface) ~default:"surface")

(* After the [=] of a definition. *)
let pp_value name_of ppf : Surface.t Closed.value -> unit = function
  | (Truth _ | Function _) as value ->
      Format.fprintf ppf "(%a)" (pp_element name_of) value
  | Thing surface -> Surface.pp_with ~name_of print_number ppf surface
  | value -> pp_element name_of ppf value

let pp_parameter ppf ({ name; default; _ } : Expression.parameter) =
  Format.pp_print_string ppf name;
  Option.iter (Format.fprintf ppf ": %a" Expression.pp) default

let pp_body ppf (e : Expression.t) =
  match e.desc with
  | Word _ | Varying _ -> Expression.pp ppf e
  | _ -> Format.fprintf ppf "(%a)" Expression.pp e

let pp_definition name_of ppf (name, definition) =
  let pp_sep ppf () = Format.pp_print_string ppf ", " in
  match (definition : Surface.t Closed.definition) with
  | Value value -> Format.fprintf ppf "%s = %a" name (pp_value name_of) value
  | Defined { parameters; body } ->
      Format.fprintf ppf "%s(%a) = %a" name
        (Format.pp_print_list ~pp_sep pp_parameter)
        parameters pp_body body

let definitions ~name_of ppf { Closed.definitions; _ } =
  List.iter
    (Format.fprintf ppf "let %a@\n" (pp_definition name_of))
    definitions

let definition named =
  Format.asprintf "%a" (pp_definition (fun _ -> None)) named

(* {1 For a reader} *)

let rec datum : Surface.t Closed.value -> Datum.t = function
  | Number x -> Number x
  | Truth truth -> Truth truth
  | Text text -> Text text
  | Vector v -> Vector v
  | List elements ->
      let count = Array.length elements in
      let first = Array.sub elements 0 (Int.min count 4) in
      List { first = List.map datum (Array.to_list first); count }
  | Function name -> Other name
  | Thing surface -> Other (Format.asprintf "%a" Surface.pp surface)

let told { Closed.definitions; _ } =
  let pp_sep ppf () = Format.pp_print_string ppf ", " in
  let define (name, definition) =
    match (definition : Surface.t Closed.definition) with
    | Value value ->
        Printf.sprintf "%s = %s" name (Datum.to_string (datum value))
    | Defined { parameters; body } ->
        Format.asprintf "%s(%a) = %a" name
          (Format.pp_print_list ~pp_sep pp_parameter)
          parameters Expression.pp body
  in
  List.map define definitions

let names { Closed.name; body; definitions } =
  let of_definition (name, definition) =
    let name = String.lowercase_ascii name in
    match (definition : Surface.t Closed.definition) with
    | Value _ -> [ name ]
    | Defined { parameters; body } -> name :: Names.bound parameters body
  in
  (String.lowercase_ascii name :: Names.bound [] body)
  @ List.concat_map of_definition definitions
