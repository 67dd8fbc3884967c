open Raylab_geometry
open Raylab_scene

type hit = {
  mutable x : float;
  mutable y : float;
  mutable z : float;
  mutable nx : float;
  mutable ny : float;
  mutable nz : float;
  mutable offset : float;
}

type color = { mutable r : float; mutable g : float; mutable b : float }

type t = {
  scene : Flat_scene.t;
  observe : (Event.t -> unit) option;
  query : Query.t;
  tally : Tally.t;
  ray : Raw_ray.t;
  shadow_ray : Raw_ray.t;
  hit : hit;
  light : color;
  color : color;
  row : float array; (* what a surface that varies denotes at the hit *)
}

let create ?observe (scene : Flat_scene.t) =
  let black () = { r = 0.; g = 0.; b = 0. } in
  {
    scene;
    observe;
    query = scene.index ();
    tally = Tally.create ();
    ray = Raw_ray.create ();
    shadow_ray = Raw_ray.create ();
    hit = { x = 0.; y = 0.; z = 0.; nx = 0.; ny = 0.; nz = 0.; offset = 0. };
    light = black ();
    color = black ();
    row = Array.make Flat_scene.object_size 0.;
  }

let[@inline] set color r g b =
  color.r <- Saturate.limit r;
  color.g <- Saturate.limit g;
  color.b <- Saturate.limit b

let color_of ({ r; g; b } : color) = Color.make r g b

let load t (r : Ray.t) =
  let r = (r :> Raw_ray.t) in
  Raw_ray.set_origin t.ray r.ox r.oy r.oz;
  Raw_ray.set_direction t.ray r.dx r.dy r.dz;
  t.ray.reach <- r.reach
