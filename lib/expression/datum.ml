open Raylab_geometry

type t =
  | Number of float
  | Truth of bool
  | Text of string
  | Vector of Vec3.t
  | List of { first : t list; count : int }
  | Other of string

let rec pp ppf = function
  | Number x -> Number.pp ppf x
  | Truth truth -> Format.pp_print_bool ppf truth
  | Text text -> Format.fprintf ppf "\"%s\"" text
  | Vector { x; y; z } ->
      Format.fprintf ppf "[%a, %a, %a]" Number.pp x Number.pp y Number.pp z
  | List { first; count } -> pp_list ppf first count
  | Other words -> Format.pp_print_string ppf words

and pp_list ppf first count =
  let pp_sep ppf () = Format.pp_print_string ppf ", " in
  Format.fprintf ppf "[%a" (Format.pp_print_list ~pp_sep pp) first;
  if count > List.length first then Format.fprintf ppf ", ... %d in all" count;
  Format.pp_print_char ppf ']'

let to_string datum =
  let text = Buffer.create 16 in
  let ppf = Format.formatter_of_buffer text in
  Format.fprintf ppf "%a@?" pp datum;
  Buffer.contents text
