open Raylab_geometry
open Raylab_scene

type lamp = { light : Light.t; power : Color.t }

type t = {
  scene : Scene.t;
  shapes : Shape.t array;
  meanings : Surface.meaning array;
  lamps : lamp list;
  query : Query.t;
  offset : float;
}

(* The original's offset of 1e-5 suits scenes whose canvas and depth measure a
   few units; as a part of those it suits the same scenes at any scale. *)
let relative_offset = 1e-5

let prepare ?(query = Query.brute_force) (scene : Scene.t) =
  let objects = Array.of_list scene.objects in
  let shapes = Array.map (fun (o : Object.t) -> o.shape) objects in
  {
    scene;
    shapes;
    meanings =
      Array.map (fun (o : Object.t) -> Surface.meaning o.surface) objects;
    lamps =
      List.map (fun light -> { light; power = Light.power light }) scene.lights;
    query = query shapes;
    offset = relative_offset *. Camera.scale scene.camera;
  }

let scene t = t.scene
let objects t = Array.of_list t.scene.objects
let hit t number ray = Hit.make ~offset:t.offset t.shapes.(number) ray

let nearest_hit t ray =
  let number = t.query.nearest ray in
  if number = Query.no_shape then None else Some (number, hit t number ray)

let is_blocked t (tally : Tally.t) light { Hit.point; normal; offset; _ } =
  match Light.shadow_ray light ~point ~normal ~offset with
  | None -> false
  | Some shadow_ray ->
      tally.shadow <- tally.shadow + 1;
      let blocked = t.query.blocked shadow_ray in
      if blocked then tally.blocked <- tally.blocked + 1;
      blocked

let light_of_lamp t tally (hit : Hit.t) { light; power } =
  match Light.incidence light ~point:hit.point ~normal:hit.normal with
  | Some incidence
    when incidence.cosine > 0. && not (is_blocked t tally light hit) ->
      Light.contribution ~power incidence
  | _ -> Color.black

let light_at t tally hit =
  let add sum lamp = Color.add sum (light_of_lamp t tally hit lamp) in
  Saturate.color (List.fold_left add Color.black t.lamps)

let light t hit = light_at t (Tally.create ()) hit

let rec trace t (tally : Tally.t) ray left =
  let number = if left = 0 then Query.no_shape else t.query.nearest ray in
  if number = Query.no_shape then t.scene.background
  else (
    tally.hits <- tally.hits + 1;
    let hit = hit t number ray in
    let { Surface.emission; albedo; mirror } = t.meanings.(number) in
    let diffused =
      if Color.equal albedo Color.black then Color.black
      else Saturate.color (Color.multiply albedo (light_at t tally hit))
    and mirrored =
      if mirror = 0. then Color.black
      else Saturate.color (Color.scale mirror (reflection t tally ray hit left))
    in
    Saturate.color (Color.add (Color.add emission diffused) mirrored))

and reflection t tally ray hit left =
  if left > 1 then tally.reflected <- tally.reflected + 1;
  let mirrored = Ray.reflect ray ~at:(Hit.start hit) ~normal:hit.normal in
  trace t tally mirrored (left - 1)

let counted_ray t tally ray = trace t tally ray t.scene.ray_depth
let ray t r = counted_ray t (Tally.create ()) r

let counted_pixel t (tally : Tally.t) ~x ~y =
  tally.primary <- tally.primary + 1;
  counted_ray t tally (Camera.primary_ray t.scene.camera ~x ~y)

let pixel t ~x ~y = counted_pixel t (Tally.create ()) ~x ~y

let primary_rays (scene : Scene.t) =
  let { Camera.width; height; _ } = scene.camera in
  Seq.concat_map
    (fun y -> Seq.init width (fun x -> Camera.primary_ray scene.camera ~x ~y))
    (Seq.init height Fun.id)
