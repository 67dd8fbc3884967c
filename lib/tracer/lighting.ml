open Raylab_geometry
open Raylab_geometry.Numbers
open Raylab_scene
open Registers
open Hitting

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
  (* A light whose distance cannot be squared gives nothing: see
     Light.spherical. The limit of the offset sees to it that [way] below can
     be squared as well. *)
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
    (* there is no way to a light where the shadow ray would start *)
    if way = 0. || not (is_blocked t at) then
      add_light t at cosine (Saturate.limit (1. /. squared)))
  else tell_facing_away t at cosine

(* Puts the light that reaches the hit into its register. *)
let gather t =
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
