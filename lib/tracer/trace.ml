open Raylab_geometry
open Raylab_scene

type t = { scene : Scene.t; lights : Light.t array; ready : Flat_scene.t }

let prepare ?(domains = 1) ?(quick = true) ?index (scene : Scene.t) =
  let index = Option.value index ~default:(Bvh.index ~domains ~quick) in
  {
    scene;
    lights = Array.of_list scene.lights;
    ready = Flat_scene.prepare ~quick ~index scene;
  }

let scene t = t.scene
let numbered_object t number = t.ready.objects.(number - 1)
let numbered_light t number = t.lights.(number - 1)
let evaluator ?observe t = Evaluator.create ?observe t.ready
let ray t r = Evaluator.ray (evaluator t) r
let pixel t ~x ~y = Evaluator.pixel (evaluator t) ~x ~y
let nearest_hit t r = Evaluator.nearest_hit (evaluator t) r
let light t hit = Evaluator.light (evaluator t) hit

let primary_rays (scene : Scene.t) =
  let { Camera.width; height; _ } = scene.camera in
  Seq.concat_map
    (fun y -> Seq.init width (fun x -> Camera.primary_ray scene.camera ~x ~y))
    (Seq.init height Fun.id)
