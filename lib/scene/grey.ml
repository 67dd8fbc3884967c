open Raylab_geometry

type t = float

let black = 0.
let white = 1.
let add = ( +. )
let scale = ( *. )
let multiply = ( *. )
let of_color = Color.luminance
let to_color g = Color.make g g g
let to_bytes g = Color.to_bytes (to_color g)
let equal = ( = )
let pp ppf g = Format.fprintf ppf "grey %a" Number.pp g
