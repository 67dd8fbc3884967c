open Raylab_geometry
open Raylab_scene

let pp_exact ppf x = Format.fprintf ppf "%.17g" x

let pp_exact_vec3 ppf { Vec3.x; y; z } =
  Format.fprintf ppf "(%a, %a, %a)" pp_exact x pp_exact y pp_exact z

let pp_exact_color ppf { Color.r; g; b } =
  Format.fprintf ppf "rgb %a %a %a" pp_exact r pp_exact g pp_exact b

let is_near e a b = a = b || abs_float (a -. b) <= e

let is_near_vec3 e (u : Vec3.t) (v : Vec3.t) =
  is_near e u.x v.x && is_near e u.y v.y && is_near e u.z v.z

let is_near_color e (a : Color.t) (b : Color.t) =
  is_near e a.r b.r && is_near e a.g b.g && is_near e a.b b.b

let number = Alcotest.testable pp_exact Float.equal
let near e = Alcotest.testable pp_exact (is_near e)
let vec3 = Alcotest.testable pp_exact_vec3 Vec3.equal
let vec3_near e = Alcotest.testable pp_exact_vec3 (is_near_vec3 e)
let pp_direction ppf (d : Direction.t) = pp_exact_vec3 ppf (d :> Vec3.t)

let direction_near e =
  Alcotest.testable pp_direction (fun a b ->
      is_near_vec3 e (a :> Vec3.t) (b :> Vec3.t))

let direction = direction_near 0.

let ray_near e =
  let equal (a : Ray.t) (b : Ray.t) =
    is_near_vec3 e (Ray.origin a) (Ray.origin b)
    && is_near_vec3 e (Ray.direction a :> Vec3.t) (Ray.direction b :> Vec3.t)
    && is_near e (Ray.reach a) (Ray.reach b)
  in
  Alcotest.testable Ray.pp equal

let color = Alcotest.testable pp_exact_color Color.equal

let color_about e =
  let near x y = x = y || abs_float (x -. y) <= e *. (1. +. abs_float x) in
  Alcotest.testable pp_exact_color (fun a b ->
      near a.r b.r && near a.g b.g && near a.b b.b)

let color_near e = Alcotest.testable pp_exact_color (is_near_color e)
let background = Alcotest.testable Background.pp Background.equal
let surface = Alcotest.testable Surface.pp Surface.equal

let pp_lobes ppf { Lobes.emission; albedo; mirror; highlights; refractions } =
  let pp = Format.fprintf and color = pp_exact_color in
  pp ppf "emission %a, albedo %a, mirror %a" color emission color albedo color
    mirror;
  List.iter
    (fun { Lobes.sharpness; shine } ->
      pp ppf ", highlight %h %a" sharpness color shine)
    highlights;
  List.iter
    (fun { Lobes.index; plain; fresnel; glass } ->
      pp ppf ", refraction %h %a %a %a" index color plain color fresnel color
        glass)
    refractions

let lobes_near e =
  let close a b = is_near (e *. Float.max (abs_float a) (abs_float b)) a b in
  let close_color (a : Color.t) (b : Color.t) =
    close a.r b.r && close a.g b.g && close a.b b.b
  in
  Alcotest.testable pp_lobes (fun a b ->
      close_color a.Lobes.emission b.Lobes.emission
      && close_color a.albedo b.albedo
      && close_color a.mirror b.mirror
      && List.equal
           (fun (a : Lobes.highlight) (b : Lobes.highlight) ->
             a.sharpness = b.sharpness && close_color a.shine b.shine)
           a.highlights b.highlights
      && List.equal
           (fun (a : Lobes.refraction) (b : Lobes.refraction) ->
             a.index = b.index
             && close_color a.plain b.plain
             && close_color a.fresnel b.fresnel
             && close_color a.glass b.glass)
           a.refractions b.refractions)

let lobes = lobes_near 0.
let light = Alcotest.testable Light.pp Light.equal
let object_ = Alcotest.testable Object.pp Object.equal
let scene = Alcotest.testable Scene.pp Scene.equal
let levels = Alcotest.(triple int int int)
