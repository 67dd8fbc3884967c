open Raylab_geometry

type t = { flat : Mesh.t; smooth : Mesh.t Lazy.t }

let make ~name facets =
  let flat = Mesh.make ~name facets in
  { flat; smooth = lazy (Mesh.smooth (Smooth.facets facets) flat) }

let mesh { flat; smooth } ~is_smooth =
  if is_smooth then Lazy.force smooth else flat

let nothing =
  make ~name:""
    {
      Facets.none with
      points = [| 0.; 0.; 0.; 1.; 0.; 0.; 0.; 1.; 0. |];
      corners = [| 0; 1; 2 |];
      faces = [| 1 |];
      places = [| 1 |];
    }
