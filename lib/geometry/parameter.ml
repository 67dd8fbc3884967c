type t = Number of float | Triple of float * float * float

let of_vec3 { Vec3.x; y; z } = Triple (x, y, z)

let equal a b =
  match (a, b) with
  | Number a, Number b -> a = b
  | Triple (x, y, z), Triple (x', y', z') -> x = x' && y = y' && z = z'
  | (Number _ | Triple _), _ -> false

let pp_with pp_number ppf = function
  | Number x -> pp_number ppf x
  | Triple (x, y, z) ->
      Format.fprintf ppf "%a %a %a" pp_number x pp_number y pp_number z
