open Raylab_scene
open Raylab_tracer

let pixels scene =
  let { Camera.width; height; _ } = scene.Prepared.scene.camera in
  List.concat (List.init height (fun y -> List.init width (fun x -> (x, y))))

let explained scene =
  List.map (fun (x, y) -> Explain.pixel scene ~x ~y) (pixels scene)

let explanations scene =
  List.map
    (fun (pixel : Explain.pixel) -> ((pixel.x, pixel.y), Explain.centre pixel))
    (explained scene)

let holds ?(count = 200) ?(max_side = 6) what property =
  let test name number =
    Property.holds
      (what ^ ", " ^ name)
      ~count ~print:(Property.show Scene.pp)
      (Generate.scene ~max_side number)
      (fun scene -> property (Prepared.make scene))
  in
  [ test "everyday" Generate.everyday; test "any size" Generate.extreme ]
