open Raylab_scene
open Raylab_tracer
open Test_support

let centre ?background ?ambient ?ray_depth ?lights objects =
  let scene =
    Scene.make ?background ?ambient ?ray_depth ?lights ~objects
      (Build.camera ())
  in
  Tracer.color (Prepared.make scene)
    (Camera.primary_ray scene.camera ~x:0 ~y:0)

let sun ?(intensity = 1.) x y z =
  Light.directional ~intensity ~color:Color.white ~direction:(Build.v x y z)

let bulb ?(intensity = 1.) x y z =
  Light.spherical ~intensity ~color:Color.white ~position:(Build.v x y z)

let picture scene = fst (Render.picture ~domains:1 (Prepared.make scene))

let drawing letter picture =
  List.init (Picture.height picture) (fun y ->
      String.init (Picture.width picture) (fun x ->
          letter (Picture.get picture ~x ~y)))

let pixels picture =
  let row y = List.init (Picture.width picture) (fun x -> (x, y)) in
  List.concat (List.init (Picture.height picture) row)
