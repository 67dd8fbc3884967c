open Raylab_geometry
open Raylab_geometry.Numbers
open Raylab_scene

(* {1 Registers} *)

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

let tally t = t.tally

let[@inline] set color r g b =
  color.r <- Saturate.limit r;
  color.g <- Saturate.limit g;
  color.b <- Saturate.limit b

let color_of ({ r; g; b } : color) = Color.make r g b

(* {1 Hits} *)

(* A computed point lies within a few units in the last place (2^-52 each) of the
   largest number that went into it; this leaves some room. *)
let rounding = 0x1p-44

(* Where doubles end: no hit lies farther out, nor is moved farther off, so that
   what is computed from it is finite. *)
let farthest = 0x1p1022
let farthest_offset = rounding *. farthest

let[@inline] within x =
  if x > farthest then farthest else if x < -.farthest then -.farthest else x

(* [set_hit t x y z nx ny nz size] puts the point (x, y, z) and the normal there
   into the register, the normal on the side of the ray. [size] is the size of
   the shape, where its numbers went into the point. *)
let[@inline] set_hit t x y z nx ny nz size =
  let ray = t.ray and hit = t.hit in
  let against = (nx *. ray.dx) +. (ny *. ray.dy) +. (nz *. ray.dz) in
  let side = if against > 0. then -1. else 1. in
  hit.x <- x;
  hit.y <- y;
  hit.z <- z;
  hit.nx <- side *. nx;
  hit.ny <- side *. ny;
  hit.nz <- side *. nz;
  let least =
    rounding
    *. (size +. abs_float x +. abs_float y +. abs_float z +. abs_float ray.ox
      +. abs_float ray.oy +. abs_float ray.oz)
  and usual = t.scene.offset in
  if usual >= least then hit.offset <- usual
  else (
    hit.offset <- (if least <= farthest_offset then least else farthest_offset);
    hit.x <- within x;
    hit.y <- within y;
    hit.z <- within z)

let find_hit t number =
  let ray = t.ray in
  let distance = ray.reach in
  let x = ray.ox +. (distance *. ray.dx)
  and y = ray.oy +. (distance *. ray.dy)
  and z = ray.oz +. (distance *. ray.dz) in
  let o = t.scene.numbers and at = Flat_scene.object_size * number in
  let radius = o.%(at + 3) in
  if radius > 0. then
    let cx = o.%(at) and cy = o.%(at + 1) and cz = o.%(at + 2) in
    let vx = x -. cx and vy = y -. cy and vz = z -. cz in
    let squared = (vx *. vx) +. (vy *. vy) +. (vz *. vz) in
    if squared > 0. && squared < infinity then
      let scale = 1. /. sqrt squared in
      let nx = vx *. scale and ny = vy *. scale and nz = vz *. scale in
      (* The sum above carries the rounding errors of origin and distance; the
         point of the sphere nearest to it only those of the sphere. *)
      set_hit t
        (cx +. (radius *. nx))
        (cy +. (radius *. ny))
        (cz +. (radius *. nz))
        nx ny nz radius
    else set_hit t x y z ray.dx ray.dy ray.dz radius
  else
    let shape = t.scene.objects.(number).shape in
    let n = (Shape.normal_raw shape x y z :> Vec3.t) in
    set_hit t x y z n.x n.y n.z 0.

let hit_of t number =
  let { x; y; z; nx; ny; nz; offset } = t.hit in
  {
    Hit.number = number + 1;
    t = t.ray.reach;
    point = Vec3.make x y z;
    normal = Direction.of_vec3_exn (Vec3.make nx ny nz);
    offset;
  }

(* {1 Light} *)

let number_of_light at = (at / Flat_scene.light_size) + 1

(* What blocks the shadow ray is of interest to an observer only. *)
let tell_blocker observe t at =
  let shadow = t.shadow_ray in
  let by = t.query.nearest shadow + 1 in
  let { Vec3.x; y; z } = Ray.at (Ray.of_raw shadow) shadow.reach in
  let point = Vec3.make (within x) (within y) (within z) in
  observe
    (Event.Blocked { light = number_of_light at; by; t = shadow.reach; point })

(* Whether something is in the way of the light at [at]. *)
let is_blocked t at =
  let tally = t.tally in
  tally.shadow <- tally.shadow + 1;
  (match t.observe with
  | None -> ()
  | Some observe ->
      let ray = Ray.of_raw t.shadow_ray in
      observe (Shadow_ray { light = number_of_light at; ray }));
  let reach = t.shadow_ray.reach in
  let blocked = t.query.blocked at t.shadow_ray in
  if blocked then (
    tally.blocked <- tally.blocked + 1;
    match t.observe with
    | None -> ()
    | Some observe ->
        (* the answer may have shortened the ray *)
        t.shadow_ray.reach <- reach;
        tell_blocker observe t at);
  blocked

let tell_facing_away t at cosine =
  match t.observe with
  | None -> ()
  | Some observe -> observe (Faces_away { light = number_of_light at; cosine })

(* Adds what the light at [at] gives: cosine * falloff * power. *)
let[@inline] add_light t at cosine falloff =
  let l = t.scene.lights and sum = t.light in
  let k = Saturate.limit (cosine *. falloff) in
  let r = Saturate.limit (k *. l.%(at + 4))
  and g = Saturate.limit (k *. l.%(at + 5))
  and b = Saturate.limit (k *. l.%(at + 6)) in
  set sum (sum.r +. r) (sum.g +. g) (sum.b +. b);
  match t.observe with
  | None -> ()
  | Some observe ->
      let contribution = Color.make r g b in
      observe
        (Lit { light = number_of_light at; cosine; falloff; contribution })

let directional_light t at =
  let l = t.scene.lights and hit = t.hit in
  let lx = l.%(at + 1) and ly = l.%(at + 2) and lz = l.%(at + 3) in
  let cosine = (hit.nx *. lx) +. (hit.ny *. ly) +. (hit.nz *. lz) in
  if cosine > 0. then (
    Raw_ray.set_direction t.shadow_ray lx ly lz;
    t.shadow_ray.reach <- infinity;
    if not (is_blocked t at) then add_light t at cosine 1.)
  else tell_facing_away t at cosine

let point_light t at =
  let l = t.scene.lights and hit = t.hit and shadow = t.shadow_ray in
  let lx = l.%(at + 1) and ly = l.%(at + 2) and lz = l.%(at + 3) in
  let wx = lx -. hit.x and wy = ly -. hit.y and wz = lz -. hit.z in
  let facing = (hit.nx *. wx) +. (hit.ny *. wy) +. (hit.nz *. wz)
  and squared = (wx *. wx) +. (wy *. wy) +. (wz *. wz) in
  (* a light whose distance cannot be squared gives nothing: see Light.point *)
  let cosine =
    if squared > 0. && squared < farthest && hit.offset < 0x1p500 then
      facing /. sqrt squared
    else 0.
  in
  if cosine > 0. then (
    let vx = lx -. shadow.ox
    and vy = ly -. shadow.oy
    and vz = lz -. shadow.oz in
    let way = sqrt ((vx *. vx) +. (vy *. vy) +. (vz *. vz)) in
    let scale = 1. /. way in
    Raw_ray.set_direction shadow (vx *. scale) (vy *. scale) (vz *. scale);
    shadow.reach <- way -. hit.offset;
    (* there is no way to a light where the shadow ray would start, and none that
       a double could hold to one far beyond *)
    if way = 0. || way = infinity || not (is_blocked t at) then
      add_light t at cosine (Saturate.limit (1. /. squared)))
  else tell_facing_away t at cosine

(* Puts the light that reaches the hit into its register. *)
let gather_light t =
  let l = t.scene.lights and hit = t.hit in
  set t.light 0. 0. 0.;
  Raw_ray.set_origin t.shadow_ray
    (hit.x +. (hit.offset *. hit.nx))
    (hit.y +. (hit.offset *. hit.ny))
    (hit.z +. (hit.offset *. hit.nz));
  let at = ref 0 in
  while !at < Array.length l do
    if l.%(!at) > 0. then point_light t !at else directional_light t !at;
    at := !at + Flat_scene.light_size
  done

(* Puts the light that the surface at [at] in [o] returns into the register
   [color]. *)
let diffuse t o at =
  let ar = o.%(at + Flat_scene.albedo_at)
  and ag = o.%(at + Flat_scene.albedo_at + 1)
  and ab = o.%(at + Flat_scene.albedo_at + 2) in
  let light = t.light in
  if ar > 0. || ag > 0. || ab > 0. then gather_light t else set light 0. 0. 0.;
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

let tell_hit t number =
  match t.observe with
  | None -> ()
  | Some observe -> observe (Nearest_hit (hit_of t number))

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
    find_hit t number;
    tell_hit t number;
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

let load t (r : Ray.t) =
  let r = (r :> Raw_ray.t) in
  Raw_ray.set_origin t.ray r.ox r.oy r.oz;
  Raw_ray.set_direction t.ray r.dx r.dy r.dz;
  t.ray.reach <- r.reach

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
    find_hit t number;
    Some (hit_of t number))

let light t { Hit.point = p; normal; offset; _ } =
  let n = (normal :> Vec3.t) and hit = t.hit in
  hit.x <- p.x;
  hit.y <- p.y;
  hit.z <- p.z;
  hit.nx <- n.x;
  hit.ny <- n.y;
  hit.nz <- n.z;
  hit.offset <- offset;
  gather_light t;
  color_of t.light
