open Raylab_geometry

type t = { shape : Shape.t; surface : Surface.t; origin : Origin.t }

let make ?(origin = Origin.Unknown) shape surface = { shape; surface; origin }

let transformed change o =
  let keep_own = Surface.varies o.surface in
  { o with shape = Shape.transformed ~keep_own change o.shape }

let equal a b =
  Shape.equal a.shape b.shape && Surface.equal a.surface b.surface

let pp ppf { shape; surface; _ } =
  Format.fprintf ppf "%a, %a" Shape.pp shape Surface.pp surface
