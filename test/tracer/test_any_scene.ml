(* What holds of every scene, however strange its numbers. *)

open Raylab_geometry
open Raylab_scene
open Raylab_tracer
open Test_support

let is_light x = Float.is_finite x && x >= 0.
let is_color (c : Color.t) = is_light c.r && is_light c.g && is_light c.b
let print = Property.show Scene.pp

let pixels scene =
  let prepared = Prepared.make scene in
  Seq.map (Tracer.color prepared) (Camera.primary_rays scene.camera)

let finite name number =
  Property.holds name ~count:1000 ~print (Generate.scene ~max_side:6 number)
    (fun scene -> Seq.for_all is_color (pixels scene))

let any_ray =
  Property.holds "so with any ray" ~count:1000
    QCheck2.Gen.(
      pair
        (Generate.scene ~max_side:1 Generate.extreme)
        (Generate.ray Generate.extreme))
    (fun (scene, ray) -> is_color (Tracer.color (Prepared.make scene) ray))

let ray_is_pixel =
  Property.holds "a pixel of one sample is its primary ray" ~count:200 ~print
    (Generate.scene Generate.everyday) (fun scene ->
      let film = Film.with_samples 1 scene.film in
      let scene = Scene.with_film film scene in
      let prepared = Prepared.make scene in
      let { Camera.width; height; _ } = scene.camera in
      let x = width / 2 and y = height / 3 in
      Color.equal
        (Tracer.pixel prepared ~x ~y)
        (Tracer.color prepared (Sample_ray.make scene ~x ~y 0)
        |> Film.expose film))

(* A grey scene is grey in every pixel, to the last bit: see Grey. *)
let grey_stays_grey =
  Property.holds "greyscale has equal channels" ~count:300 ~print
    (Generate.scene ~max_side:6 Generate.extreme) (fun scene ->
      Seq.for_all
        (fun (c : Color.t) -> c.r = c.g && c.g = c.b)
        (pixels (Scene.greyscale scene)))

(* What a warning says is so: such a light adds nothing to any pixel. *)
let kept_in_gives_nothing =
  let with_lights lights { Scene.camera; background; ray_depth; objects; _ } =
    Scene.make camera ~ray_depth ~lights ~objects |> Scene.with_sky background
  in
  Property.holds "a light that is kept in gives nothing" ~count:2000 ~print
    (Generate.scene ~max_side:6 Generate.everyday) (fun scene ->
      let dark = pixels (with_lights [] scene) in
      let gives_nothing light =
        Kept_in.warnings scene.camera [ light ] scene.objects = []
        || Seq.equal Color.equal dark (pixels (with_lights [ light ] scene))
      in
      List.for_all gives_nothing scene.lights)

let surface_of (o : Object.t) part =
  match o.shape with
  | Solid s -> o.primitives.(Solid.member_of s ~part).surface
  | _ -> o.surface

let own_point shape part ray t =
  let raw = Raw_ray.create () and spot = Spot.create () in
  let o = Ray.origin ray and d = (Ray.direction ray :> Vec3.t) in
  Raw_ray.set_origin raw o.x o.y o.z;
  Raw_ray.set_direction raw d.x d.y d.z;
  raw.reach <- t;
  Shape.settle shape ~part raw spot;
  Spot.own spot

(* That of the first of the objects that are hit at the least distance, with the
   own point there. *)
let nearest_surface (scene : Scene.t) ray =
  let usual = Offset.of_scale (Camera.scale scene.camera) in
  let nearer (best, limit) (o : Object.t) =
    let shape = Shape.with_tolerance usual o.shape in
    match Shape.nearest shape ray with
    | Some (t, part) when t < limit ->
        (Some (surface_of o part, own_point shape part ray t), t)
    | _ -> (best, limit)
  in
  fst (List.fold_left nearer (None, infinity) scene.objects)

let sky = Color.make 0.1 0.5 0.7

(* What a refraction mirrors and lets through, where the ray hits it. *)
let sent_on prepared ray { Lobes.index; plain; fresnel; glass } =
  let { Hit.point; normal; shading; outside; _ } =
    Option.get (Tracer.nearest_hit prepared ray)
  and refraction = Refraction.create () in
  let normal = Option.value shading ~default:normal in
  let spot = Spot.of_point ~point ~normal ~offset:0. in
  spot.side <- (if outside then 1. else -1.);
  Refraction.meet refraction spot (Ray.to_raw ray) ~index;
  let { Refraction.share; _ } = refraction in
  Color.add plain
    (Color.add (Color.scale share fresnel) (Color.scale (1. -. share) glass))

(* With one ray and no light the colour is what is emitted and the mirror's part
   of the background. *)
let lobes =
  Property.holds "one ray without light shows the lobes" ~count:500 ~print
    (Generate.scene ~max_side:1 Generate.everyday) (fun scene ->
      let scene =
        Scene.make ~background:sky ~ray_depth:1 ~objects:scene.objects
          scene.camera
      in
      let ray = Camera.primary_ray scene.camera ~x:0 ~y:0 in
      let expected =
        match nearest_surface scene ray with
        | None -> sky
        | Some (surface, at) ->
            let { Lobes.emission; mirror; refractions; _ } =
              Surface.lobes ~at surface
            in
            List.map (sent_on (Prepared.make scene) ray) refractions
            |> List.fold_left Color.add mirror
            |> Color.multiply sky |> Color.add emission
      in
      Alcotest.equal (Same.color_near 1e-9) expected
        (Tracer.color (Prepared.make scene) ray))

let suite =
  ( "Any scene",
    [
      finite "colours are finite and not negative" Generate.everyday;
      finite "so with numbers of any size" Generate.extreme;
      any_ray;
      ray_is_pixel;
      grey_stays_grey;
      lobes;
      kept_in_gives_nothing;
    ] )
