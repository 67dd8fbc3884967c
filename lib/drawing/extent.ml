open Raylab_geometry
open Raylab_scene

let distance u v = Vec3.length (Vec3.sub u v)

(* {1 What is near} *)

let boxes (scene : Scene.t) =
  List.filter_map (fun (o : Object.t) -> Shape.box o.shape) scene.objects

let middle = function
  | [] -> 0.
  | numbers ->
      let sorted = List.sort Float.compare numbers in
      List.nth sorted ((List.length sorted - 1) / 2)

(* How far from the eye something may be. *)
let range (scene : Scene.t) boxes hits =
  let eye = Camera.eye scene.camera in
  let { Camera.canvas_width; canvas_height; depth; _ } = scene.camera in
  let usual = 2. *. Float.max depth (Float.max canvas_width canvas_height) in
  let distances =
    List.filter Float.is_finite
      (List.map (distance eye) (hits @ List.map Box3.centre boxes))
  in
  Float.max usual (3. *. middle distances)

(* {1 The box} *)

let pointwise f { Vec3.x; y; z } (v : Vec3.t) =
  Vec3.make (f x v.x) (f y v.y) (f z v.z)

(* No picture tells apart what is beyond these. *)
let largest = 1e100
let smallest = 1e-100

let clamp { Vec3.x; y; z } =
  let clamp x = Float.max (-.largest) (Float.min largest x) in
  Vec3.make (clamp x) (clamp y) (clamp z)

let around points =
  let points = List.map clamp points in
  let first = List.hd points in
  let fold f = List.fold_left (pointwise f) first points in
  Box3.make ~low:(fold Float.min) ~high:(fold Float.max)

(* No side may be shorter than this part of the longest, and there is a margin
   of that part all around. *)
let least_side = 0.35
let margin = 0.04

let widen { Box3.low; high } =
  let { Vec3.x; y; z } = Vec3.sub high low in
  let longest = Float.max smallest (Float.max x (Float.max y z)) in
  let grow side =
    (Float.max 0. ((least_side *. longest) -. side) /. 2.)
    +. (margin *. longest)
  in
  let more = Vec3.make (grow x) (grow y) (grow z) in
  Box3.make ~low:(Vec3.sub low more) ~high:(Vec3.add high more)

let of_path (scene : Scene.t) { Path.hits; _ } =
  let eye = Camera.eye scene.camera in
  let a, b, c, d = Camera.corners scene.camera in
  let boxes = boxes scene
  and hits = List.map (fun (hit : Path.hit) -> hit.point) hits in
  let range = range scene boxes hits in
  let is_near point = distance eye point <= range in
  let lights = List.concat_map Light.places scene.lights
  and extents (box : Box3.t) =
    if distance eye (Box3.centre box) +. Box3.reach box <= range then
      [ box.low; box.high ]
    else []
  in
  widen
    (around
       ([ eye; a; b; c; d ]
       @ List.filter is_near (hits @ lights)
       @ List.concat_map extents boxes))
