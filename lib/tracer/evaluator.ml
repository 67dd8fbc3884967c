open Raylab_geometry
open Raylab_geometry.Numbers
open Raylab_scene
open Registers

type t = Registers.t

let create = Registers.create
let tally t = t.tally

(* {1 Surfaces} *)

(* Puts the light that the surface at [at] in [o] returns into the register
   [color]. *)
let diffuse t o at =
  let ar = o.%(at + Flat_scene.albedo_at)
  and ag = o.%(at + Flat_scene.albedo_at + 1)
  and ab = o.%(at + Flat_scene.albedo_at + 2) in
  let light = t.light in
  if ar > 0. || ag > 0. || ab > 0. then Lighting.gather t
  else set light 0. 0. 0.;
  set t.color (ar *. light.r) (ag *. light.g) (ab *. light.b)

(* {1 Rays} *)

(* Turns the ray into the one that the hit's surface mirrors. *)
let reflect t =
  let ray = t.ray and hit = t.hit in
  let nx = hit.nx and ny = hit.ny and nz = hit.nz in
  Raw_ray.set_origin ray
    (hit.x +. (hit.offset *. nx))
    (hit.y +. (hit.offset *. ny))
    (hit.z +. (hit.offset *. nz));
  let twice = 2. *. ((nx *. ray.dx) +. (ny *. ray.dy) +. (nz *. ray.dz)) in
  let dx = ray.dx -. (twice *. nx)
  and dy = ray.dy -. (twice *. ny)
  and dz = ray.dz -. (twice *. nz) in
  (* Rounding errors would add up along a chain of mirrors. The length is almost
     1, where (3 - s) / 2 is as good as 1 / sqrt s. *)
  let scale = 1.5 -. (0.5 *. ((dx *. dx) +. (dy *. dy) +. (dz *. dz))) in
  Raw_ray.set_direction ray (dx *. scale) (dy *. scale) (dz *. scale);
  ray.reach <- infinity

let tell_background t left =
  match t.observe with
  | None -> ()
  | Some observe ->
      let color = color_of t.color in
      observe (if left = 0 then Chain_ended color else Missed color)

let tell_bounce t left =
  match t.observe with
  | None -> ()
  | Some observe -> observe (Bounce { ray = Ray.of_raw t.ray; left })

(* Puts what the surface denotes at the hit into [row]. *)
let ask_surface t number =
  let { x; y; z; _ } = t.hit in
  let surface = t.scene.objects.(number).surface in
  Flat_scene.write_meaning t.row
    (Surface.meaning (Surface.at surface (Vec3.make x y z)))

(* Puts the colour of the ray, with [left] rays left in its chain, into the
   register [color]. *)
let rec trace t left =
  let number = if left = 0 then Query.no_shape else t.query.nearest t.ray in
  if number = Query.no_shape then (
    let { Color.r; g; b } = t.scene.source.background in
    set t.color r g b;
    tell_background t left)
  else (
    t.tally.hits <- t.tally.hits + 1;
    Hitting.find t number;
    Hitting.tell t number;
    let o = t.scene.numbers and at = Flat_scene.object_size * number in
    if o.%(at + Flat_scene.varies_at) > 0. then (
      ask_surface t number;
      shade t t.row 0 left)
    else shade t o at left)

(* The same for a ray that hits: what the surface denotes is at [at] in [o]. *)
and shade t o at left =
  (* read before the mirrored ray overwrites [row] *)
  let er = o.%(at + Flat_scene.emission_at)
  and eg = o.%(at + Flat_scene.emission_at + 1)
  and eb = o.%(at + Flat_scene.emission_at + 2) in
  diffuse t o at;
  let dr = t.color.r and dg = t.color.g and db = t.color.b in
  let lr = t.light.r and lg = t.light.g and lb = t.light.b in
  let mirror = o.%(at + Flat_scene.mirror_at) in
  if mirror > 0. then (
    reflect t;
    if left > 1 then t.tally.reflected <- t.tally.reflected + 1;
    tell_bounce t (left - 1);
    trace t (left - 1);
    let seen = t.color in
    set seen (mirror *. seen.r) (mirror *. seen.g) (mirror *. seen.b))
  else set t.color 0. 0. 0.;
  let { r = mr; g = mg; b = mb } = t.color in
  set t.color (er +. dr +. mr) (eg +. dg +. mg) (eb +. db +. mb);
  match t.observe with
  | None -> ()
  | Some observe ->
      observe
        (Mixed
           {
             emitted = Color.make er eg eb;
             light = Color.make lr lg lb;
             diffused = Color.make dr dg db;
             mirrored = Color.make mr mg mb;
             color = color_of t.color;
           })

(* {1 Questions from outside} *)

let evaluate t =
  let left = t.scene.source.ray_depth in
  (match t.observe with
  | None -> ()
  | Some observe -> observe (Cast { ray = Ray.of_raw t.ray; left }));
  trace t left;
  let color = color_of t.color in
  (match t.observe with None -> () | Some observe -> observe (Done color));
  color

let ray t r =
  load t r;
  evaluate t

let pixel t ~x ~y =
  t.tally.primary <- t.tally.primary + 1;
  Camera.aim t.scene.source.camera ~x ~y t.ray;
  evaluate t

let nearest_hit t r =
  load t r;
  let number = t.query.nearest t.ray in
  if number = Query.no_shape then None
  else (
    Hitting.find t number;
    Some (Hitting.hit t number))

let light t { Hit.point = p; normal; offset; _ } =
  let n = (normal :> Vec3.t) and hit = t.hit in
  hit.x <- p.x;
  hit.y <- p.y;
  hit.z <- p.z;
  hit.nx <- n.x;
  hit.ny <- n.y;
  hit.nz <- n.z;
  hit.offset <- offset;
  Lighting.gather t;
  color_of t.light
