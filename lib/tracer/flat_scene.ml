open Raylab_geometry
open Raylab_scene

type t = {
  source : Scene.t;
  objects : float array;
  lights : float array;
  index : Query.index;
  offset : float;
}

let object_size = 12
let emission_at = 4
let albedo_at = 7
let mirror_at = 10
let no_radius = 0.

let object_numbers (o : Object.t) =
  let { Surface.emission = e; albedo = a; mirror } =
    Surface.meaning o.surface
  in
  let cx, cy, cz, radius =
    match o.shape with
    | Sphere { cx; cy; cz; radius } -> (cx, cy, cz, radius)
    | Plane { normal; _ } ->
        let { Vec3.x; y; z } = (normal :> Vec3.t) in
        (x, y, z, no_radius)
  in
  [| cx; cy; cz; radius; e.r; e.g; e.b; a.r; a.g; a.b; mirror; 0. |]

let light_size = 7

let light_numbers light =
  let power = Light.power light in
  let kind, { Vec3.x; y; z } =
    match light.source with
    | Point position -> (1., position)
    | Directional along -> (0., (Direction.neg along :> Vec3.t))
  in
  [| kind; x; y; z; power.r; power.g; power.b |]

(* [flatten size numbers items] is the numbers of all items, one after another. *)
let flatten size numbers items =
  let flat = Array.make (size * List.length items) 0. in
  List.iteri
    (fun k item -> Array.blit (numbers item) 0 flat (k * size) size)
    items;
  flat

(* The original's offset of 1e-5 suits scenes whose canvas and depth measure a
   few units; as a part of those it suits the same scenes at any scale. *)
let relative_offset = 1e-5

let prepare ~index (source : Scene.t) =
  let shapes =
    Array.of_list (List.map (fun (o : Object.t) -> o.shape) source.objects)
  in
  {
    source;
    objects = flatten object_size object_numbers source.objects;
    lights = flatten light_size light_numbers source.lights;
    index = index shapes;
    offset = relative_offset *. Camera.scale source.camera;
  }
