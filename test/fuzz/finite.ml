open Raylab_geometry
open Raylab_scene
open Raylab_tracer

let number = Float.is_finite
let channel x = number x && x >= 0.
let color (c : Color.t) = channel c.r && channel c.g && channel c.b
let vec3 = Vec3.is_finite

let ray r =
  vec3 (Ray.origin r)
  && vec3 (Ray.direction r :> Vec3.t)
  && not (Float.is_nan (Ray.reach r))

let hit { Hit.t; point; normal; offset; _ } =
  number t && vec3 point && vec3 (normal :> Vec3.t) && number offset

let verdict = function
  | Explain.Faces_away { cosine } -> number cosine
  | Blocked { shadow_ray; t; point; _ } ->
      ray shadow_ray && number t && vec3 point
  | Lit { shadow_ray; cosine; falloff; contribution } ->
      Option.fold ~none:true ~some:ray shadow_ray
      && number cosine && number falloff && color contribution

let meaning { Surface.emission; albedo; mirror } =
  color emission && color albedo && channel mirror

let rec explanation (e : Explain.t) =
  ray e.ray && color e.color
  &&
  match e.outcome with
  | Chain_ended | Missed -> true
  | Hit s -> (
      hit s.hit && meaning s.meaning
      && List.for_all (fun { Explain.verdict = v; _ } -> verdict v) s.lights
      && List.for_all color [ s.light; s.emitted; s.diffused; s.mirrored ]
      && match s.reflection with None -> true | Some e -> explanation e)
