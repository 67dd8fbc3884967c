open Raylab_geometry
open Raylab_scene

type t = {
  source : Scene.t;
  objects : Object.t array;
  numbers : float array;
  lights : float array;
  index : Query.index;
  offset : float;
}

let object_size = 12
let emission_at = 4
let albedo_at = 7
let mirror_at = 10
let varies_at = 11
let no_radius = 0.

let object_numbers ~quick (o : Object.t) =
  let { Surface.emission = e; albedo = a; mirror } =
    Surface.meaning o.surface
  in
  let cx, cy, cz, radius =
    match o.shape with
    | Sphere { cx; cy; cz; radius } -> (cx, cy, cz, radius)
    | _ -> (0., 0., 0., no_radius)
  and varies = if quick && not (Surface.varies o.surface) then 0. else 1. in
  [| cx; cy; cz; radius; e.r; e.g; e.b; a.r; a.g; a.b; mirror; varies |]

let write_meaning row { Surface.emission = e; albedo = a; mirror } =
  let write at (c : Color.t) =
    row.(at) <- c.r;
    row.(at + 1) <- c.g;
    row.(at + 2) <- c.b
  in
  write emission_at e;
  write albedo_at a;
  row.(mirror_at) <- mirror

let light_size = 7

let light_numbers light =
  let power = Light.power light in
  let kind, { Vec3.x; y; z } =
    match light.source with
    | Spherical position -> (1., position)
    | Directional along -> (0., (Direction.neg along :> Vec3.t))
  in
  [| kind; x; y; z; power.r; power.g; power.b |]

(* [flatten size numbers items] is the numbers of all items, one after
   another. *)
let flatten size numbers items =
  let flat = Array.make (size * Array.length items) 0. in
  Array.iteri
    (fun k item -> Array.blit (numbers item) 0 flat (k * size) size)
    items;
  flat

(* The original's offset of 1e-5 suits scenes whose canvas and depth measure a
   few units; as a part of those it suits the same scenes at any scale. *)
let relative_offset = 1e-5

let prepare ~quick ~index (source : Scene.t) =
  let objects = Array.of_list source.objects in
  let shapes = Array.map (fun (o : Object.t) -> o.shape) objects in
  {
    source;
    objects;
    numbers = flatten object_size (object_numbers ~quick) objects;
    lights = flatten light_size light_numbers (Array.of_list source.lights);
    index = index shapes;
    offset = relative_offset *. Camera.scale source.camera;
  }
