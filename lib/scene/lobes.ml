open Raylab_geometry

type t = { emission : Color.t; albedo : Color.t; mirror : Color.t }

let equal a b =
  Color.equal a.emission b.emission
  && Color.equal a.albedo b.albedo
  && Color.equal a.mirror b.mirror

let pp_factor ppf ({ Color.r; g; b } as color) =
  if r = g && g = b then Number.pp ppf r else Color.pp ppf color

let pp ppf { emission; albedo; mirror } =
  Format.fprintf ppf "emission %a,@ albedo %a,@ mirror %a" Color.pp emission
    Color.pp albedo pp_factor mirror
