open Raylab_geometry

type t = { shape : Shape.t; surface : Surface.t; line : int option }

let make ?line shape surface = { shape; surface; line }

let equal a b =
  Shape.equal a.shape b.shape && Surface.equal a.surface b.surface

let pp ppf { shape; surface; _ } =
  Format.fprintf ppf "%a, %a" Shape.pp shape Surface.pp surface
