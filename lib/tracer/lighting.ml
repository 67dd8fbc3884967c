open Raylab_geometry
open Raylab_scene
open Registers

(* What blocks the shadow ray is of interest to an observer only. *)
let tell_blocker observe t light =
  let shadow = t.shadow_ray in
  t.finder.nearest shadow t.meeting;
  let { Vec3.x; y; z } = Ray.at (Ray.of_raw shadow) shadow.reach in
  let point = Offset.(Vec3.make (within x) (within y) (within z)) in
  observe
    (Event.Blocked
       { light; by = t.meeting.number + 1; t = shadow.reach; point })

(* Whether something is in the way of the shadow ray. *)
let is_blocked t light =
  let tally = t.tally in
  tally.shadow <- tally.shadow + 1;
  (match t.observe with
  | None -> ()
  | Some observe ->
      observe (Event.Shadow_ray { light; ray = Ray.of_raw t.shadow_ray }));
  let reach = t.shadow_ray.reach in
  let blocked = t.finder.blocked light t.shadow_ray in
  if blocked then (
    tally.blocked <- tally.blocked + 1;
    match t.observe with
    | None -> ()
    | Some observe ->
        (* the answer may have shortened the ray *)
        t.shadow_ray.reach <- reach;
        tell_blocker observe t light);
  blocked

let tell_facing_away t light =
  match t.observe with
  | None -> ()
  | Some observe ->
      observe (Event.Faces_away { light; cosine = t.incidence.cosine })

let tell_lit t light =
  match t.observe with
  | None -> ()
  | Some observe ->
      let { Light.cosine; falloff } = t.incidence
      and gives = Raw_color.create () in
      Light.add t.prepared.lights.(light - 1) t.incidence gives;
      let contribution = Raw_color.to_color gives in
      observe (Event.Lit { light; cosine; falloff; contribution })

(* Adds what the light of this number, from 1, gives. *)
let add t number light =
  if Light.meet light t.spot t.incidence then (
    (* there is no way to a light where the shadow ray would start *)
    let has_way = Light.aim light t.spot t.shadow_ray in
    if not (has_way && is_blocked t number) then (
      Light.add light t.incidence t.light;
      tell_lit t number))
  else tell_facing_away t number

let gather t =
  let lights = t.prepared.lights in
  Raw_color.set t.light 0. 0. 0.;
  Spot.start t.spot t.shadow_ray;
  t.shadow_ray.seed <- t.ray.seed;
  for k = 0 to Array.length lights - 1 do
    add t (k + 1) (Array.unsafe_get lights k)
  done
