open Raylab_geometry
open Raylab_scene

type t = Prepared.t

let prepare ?(domains = 1) ?(index = Bvh.index ~domains) scene =
  Prepared.make ~index scene

let scene (t : t) = t.scene
let numbered_object (t : t) number = t.objects.(number - 1)
let numbered_light (t : t) number = t.lights.(number - 1)
let evaluator ?observe t = Evaluator.create ?observe t
let ray t r = Evaluator.ray (evaluator t) r
let pixel t ~x ~y = Evaluator.pixel (evaluator t) ~x ~y
let nearest_hit t r = Evaluator.nearest_hit (evaluator t) r
let light t hit = Evaluator.light (evaluator t) hit

let primary_rays (scene : Scene.t) =
  let { Camera.width; height; _ } = scene.camera in
  Seq.concat_map
    (fun y -> Seq.init width (fun x -> Camera.primary_ray scene.camera ~x ~y))
    (Seq.init height Fun.id)
