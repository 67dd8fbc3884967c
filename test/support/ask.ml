open Raylab_geometry

let distance shape ray =
  Option.fold ~none:infinity ~some:fst (Shape.nearest shape ray)

let crossings shape ray =
  List.map
    (fun { Crossings.t; part; enters } -> (t, part, enters))
    (Shape.crossings shape ray)

let spot ?(part = 0) shape ~reach ray =
  let raw = Ray.to_raw ray and spot = Spot.create () in
  raw.reach <- reach;
  Shape.settle shape ~part raw spot;
  spot
