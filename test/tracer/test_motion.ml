(* A scene and its camera that are turned and moved together give the same
   picture. *)

open Raylab_geometry
open Raylab_expression
open Raylab_scene
open Raylab_tracer
open Test_support

let motion =
  QCheck2.Gen.(
    map3
      (fun axis angle way ->
        let sin = Degrees.sin angle and cos = Degrees.cos angle in
        Change.of_modifiers
          [ Rotated { axis; angle; sin; cos }; Translated way ])
      (Generate.direction Generate.everyday)
      (float_range (-180.) 180.)
      (Generate.vec3 Generate.everyday))

let moved_camera motion (camera : Camera.t) =
  let { Viewpoint.eye; look_at; up; _ } = camera.viewpoint in
  let affine = Change.affine motion in
  let point = Affine.point affine in
  Camera.with_viewpoint
    (Viewpoint.make_exn ~look_at:(point look_at) ~up:(Affine.vector affine up)
       (point eye))
    camera

(* That of all directions is not moved. *)
let sky = Color.make 0.2 0.4 0.6

let moved motion (scene : Scene.t) =
  Scene.make ~lens:scene.lens ~film:scene.film ~background:sky
    ~ambient:scene.ambient ~ray_depth:scene.ray_depth
    ~lights:(List.map (Light.transformed motion) scene.lights)
    ~objects:(List.map (Object.transformed motion) scene.objects)
    (moved_camera motion scene.camera)

let near (a : Color.t) (b : Color.t) =
  let near x y = abs_float (x -. y) <= 1e-6 *. (1. +. abs_float x) in
  near a.r b.r && near a.g b.g && near a.b b.b

let same =
  Property.holds "the picture stays the same" ~count:300
    ~print:(fun (scene, _) -> Property.show Scene.pp scene)
    QCheck2.Gen.(pair (Generate.scene ~max_side:8 Generate.everyday) motion)
    (fun (scene, motion) ->
      (* no exposure that makes rounding errors seen *)
      let film = Film.make ~samples:scene.film.samples () in
      let scene = Scene.with_film film scene |> Scene.with_background sky in
      let a = Prepared.make scene and b = Prepared.make (moved motion scene) in
      List.for_all
        (fun (x, y) -> near (Tracer.pixel a ~x ~y) (Tracer.pixel b ~x ~y))
        (Any.pixels a))

let suite = ("Motion", [ same ])
