(* With lengths k times as long, and spherical lights k^2 times as strong, the
   picture stays the same. *)

open Raylab_geometry
open Raylab_scene
open Raylab_tracer
open Test_support

let scale_shape k = Shape.transformed Change.(of_modifiers [ Scaled k ])

let scale_object k (o : Object.t) =
  match o.primitives with
  | [||] when not (o.is_shadowless || Surface.varies o.surface) ->
      Object.make (scale_shape k o.shape) o.surface
  | _ -> Object.transformed Change.(of_modifiers [ Scaled k ]) o

let scale_light k (light : Light.t) =
  let fades =
    match light.source with
    | Directional _ -> false
    | Spherical _ | Spot _ | Area _ -> not light.is_unfading
  in
  let squared = if fades then k *. k else 1. in
  Light.transformed Change.(of_modifiers [ Scaled k ]) light
  |> Light.map_color (Color.scale squared)

let scale_camera k (camera : Camera.t) =
  let { Camera.width; height; canvas_width; canvas_height; depth; _ } = camera
  and { Viewpoint.eye; look_at; up; _ } = camera.viewpoint in
  let viewpoint =
    Viewpoint.make_exn ~look_at:(Vec3.scale k look_at) ~up (Vec3.scale k eye)
  in
  match camera.fov with
  | Some fov -> Camera.of_fov ~width ~height ~fov viewpoint
  | None ->
      Camera.make ~width ~height ~canvas_width:(k *. canvas_width)
        ~canvas_height:(k *. canvas_height) ~depth:(k *. depth)
      |> Camera.with_viewpoint viewpoint

let scale k (scene : Scene.t) =
  Scene.make ~film:scene.film ~ambient:scene.ambient ~ray_depth:scene.ray_depth
    ~lights:(List.map (scale_light k) scene.lights)
    ~objects:(List.map (scale_object k) scene.objects)
    (scale_camera k scene.camera)
  |> Scene.with_sky scene.background

(* Rounding differs, so a level may. *)
let same_picture a b =
  let is_near m n = abs (m - n) <= 1 in
  List.for_all
    (fun (x, y) ->
      let r, g, b' = Picture.get a ~x ~y
      and r', g', b'' = Picture.get b ~x ~y in
      is_near r r' && is_near g g' && is_near b' b'')
    (Shot.pixels a)

let any_scale =
  Property.holds "the picture stays the same" ~count:300
    ~print:(fun (scene, k) ->
      Printf.sprintf "times %g: %s" k (Property.show Scene.pp scene))
    QCheck2.Gen.(
      pair
        (Generate.scene Generate.everyday)
        (oneofl [ 1e-3; 1e-2; 0.1; 10.; 100.; 1e3 ]))
    (fun (scene, k) ->
      (* a level more or less may take other samples *)
      let scene = Scene.with_film Film.default scene in
      same_picture (Shot.picture scene) (Shot.picture (scale k scene)))

let suite = ("Scale", [ any_scale ])
