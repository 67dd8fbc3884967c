open Raylab_geometry
open Raylab_scene
open Raylab_tracer
open Test_support

(* {1 The equations} *)

(* All hits of [ray] that count, each a distance and an object. *)
let hits (scene : Scene.t) ray =
  let counts t = 0. < t && t < Ray.reach ray in
  List.concat_map
    (fun (o : Object.t) ->
      Shape.intersections o.shape ray
      |> List.filter counts
      |> List.map (fun t -> (t, o)))
    scene.objects

let nearest scene ray =
  let nearer best (t, o) =
    match best with Some (t', _) when t' <= t -> best | _ -> Some (t, o)
  in
  List.fold_left nearer None (hits scene ray)

let normal_towards ray shape point =
  let n = Shape.normal shape point in
  let d = (Ray.direction ray :> Vec3.t) in
  if Vec3.dot d (n :> Vec3.t) > 0. then Direction.neg n else n

let offset (scene : Scene.t) ray shape point =
  let size = match (shape : Shape.t) with Sphere s -> s.radius | _ -> 0. in
  Float.max
    (1e-5 *. Camera.scale scene.camera)
    (0x1p-44
    *. (size +. Vec3.magnitude point +. Vec3.magnitude (Ray.origin ray)))

let light (scene : Scene.t) ~point ~normal ~offset =
  let is_blocked shadow_ray =
    List.exists
      (fun (t, _) -> Light.blocks shadow_ray t)
      (hits scene shadow_ray)
  in
  let gives light =
    match Light.shadow_ray light ~point ~normal ~offset with
    | Some shadow_ray when is_blocked shadow_ray -> Color.black
    | _ -> Light.received light ~point ~normal
  in
  List.fold_left Color.add Color.black (List.map gives scene.lights)

let rec trace (scene : Scene.t) n ray =
  match if n = 0 then None else nearest scene ray with
  | None -> scene.background
  | Some (t, { shape; surface; _ }) ->
      let point = Ray.at ray t in
      let normal = normal_towards ray shape point in
      let offset = offset scene ray shape point in
      let { Surface.emission; albedo; mirror } =
        Surface.meaning (Surface.at surface point)
      in
      let start = Vec3.add point (Vec3.scale offset (normal :> Vec3.t)) in
      let mirrored = Ray.reflect ray ~point:start ~normal in
      Color.add emission
        (Color.add
           (Color.multiply albedo (light scene ~point ~normal ~offset))
           (Color.scale mirror (trace scene (n - 1) mirrored)))

(* {1 The tracer beside them} *)

let near (a : Color.t) (b : Color.t) =
  let near x y = abs_float (x -. y) <= 1e-7 *. (1. +. abs_float x) in
  near a.r b.r && near a.g b.g && near a.b b.b

let same =
  Property.holds "the tracer is the equations" ~count:1000
    ~print:(Property.show Scene.pp)
    (Generate.scene ~max_side:6 Generate.everyday) (fun scene ->
      let prepared = Trace.prepare scene in
      Seq.for_all
        (fun ray ->
          near (Trace.ray prepared ray) (trace scene scene.ray_depth ray))
        (Trace.primary_rays scene))

let suite = ("Semantics", [ same ])
