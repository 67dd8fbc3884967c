type t =
  | Number of float
  | Triple of float * float * float
  | Text of string
  | Word of string

let of_vec3 { Vec3.x; y; z } = Triple (x, y, z)

let equal a b =
  match (a, b) with
  | Number a, Number b -> a = b
  | Triple (x, y, z), Triple (x', y', z') -> x = x' && y = y' && z = z'
  | Text a, Text b | Word a, Word b -> String.equal a b
  | (Number _ | Triple _ | Text _ | Word _), _ -> false

let pp_with pp_number ppf = function
  | Number x -> pp_number ppf x
  | Triple (x, y, z) ->
      Format.fprintf ppf "%a %a %a" pp_number x pp_number y pp_number z
  | Text text -> Format.fprintf ppf "\"%s\"" text
  | Word word -> Format.pp_print_string ppf word
