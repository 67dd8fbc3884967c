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

let hit { Hit.t; point; own_point; normal; offset; _ } =
  number t && vec3 point && vec3 own_point
  && vec3 (normal :> Vec3.t)
  && number offset

let crossed { Explain.t; point; part; _ } =
  number t && vec3 point && color part

let cone { Event.angle; part } = number angle && number part

let rec verdict = function
  | Explain.Faces_away { cosine } -> number cosine
  | Outside { angle } -> number angle
  | Mean { points; contribution; shines } ->
      List.for_all verdict points
      && color contribution && List.for_all color shines
  | Blocked { shadow_ray; t; point; _ } ->
      ray shadow_ray && number t && vec3 point
  | Lit
      {
        shadow_ray;
        cosine;
        falloff;
        cone = c;
        contribution;
        shines;
        through;
        _;
      } ->
      Option.fold ~none:true ~some:ray shadow_ray
      && number cosine && number falloff
      && Option.fold ~none:true ~some:cone c
      && color contribution && List.for_all color shines
      && List.for_all crossed through

let highlight { Lobes.sharpness; shine } = number sharpness && color shine

let refraction { Lobes.index; plain; fresnel; glass } =
  number index && color plain && color fresnel && color glass

let lobes { Lobes.emission; albedo; mirror; highlights; refractions } =
  color emission && color albedo && color mirror
  && List.for_all highlight highlights
  && List.for_all refraction refractions

let source = function
  | Event.Diffused { ambient; light } -> color ambient && color light
  | Shine { sharpness; shine } -> number sharpness && color shine
  | Mirror { weight } -> color weight
  | Refraction { index; weight; share; cosine } ->
      number index && color weight && number share && number cosine
  | Background | Emitted -> true

let rec ray_explanation (e : Explain.t) =
  ray e.ray && color e.color && List.for_all term e.terms
  &&
  match e.outcome with
  | Chain_ended | Too_faint | Missed -> true
  | Hit s ->
      hit s.hit && lobes s.lobes
      && List.for_all (fun { Explain.verdict = v; _ } -> verdict v) s.lights

and term { Explain.source = s; color = c; ray } =
  source s && color c && Option.fold ~none:true ~some:ray_explanation ray

let explanation (pixel : Explain.pixel) =
  let sample { Explain.color = c; ray } = color c && ray_explanation ray in
  color pixel.color && List.for_all sample pixel.samples
