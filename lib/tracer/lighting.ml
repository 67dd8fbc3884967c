open Raylab_geometry
open Raylab_scene
open Registers

(* What blocks the shadow ray is of interest to an observer only. *)
let tell_blocker observe t light =
  let shadow = t.shadow_ray in
  t.shadow_finder.nearest shadow t.meeting;
  let { Vec3.x; y; z } = Ray.at (Ray.of_raw shadow) shadow.reach in
  let point = Offset.(Vec3.make (within x) (within y) (within z)) in
  let number = Prepared.caster t.prepared t.meeting.number in
  let primitive = Prepared.primitive t.prepared ~number ~part:t.meeting.part in
  observe
    (Event.Blocked
       { light; by = number + 1; primitive; t = shadow.reach; point })

(* Whether something is in the way of the shadow ray. *)
let is_blocked t light =
  let tally = t.tally in
  tally.shadow <- tally.shadow + 1;
  (match t.observe with
  | None -> ()
  | Some observe ->
      observe (Event.Shadow_ray { light; ray = Ray.of_raw t.shadow_ray }));
  let reach = t.shadow_ray.reach in
  let blocked = t.shadow_finder.blocked light t.shadow_ray in
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

(* The first of the shadowless objects that light goes through. *)
let passed t has_way =
  if has_way && Option.is_some t.prepared.casters then (
    let reach = t.shadow_ray.reach in
    t.finder.nearest t.shadow_ray t.meeting;
    t.shadow_ray.reach <- reach;
    if Meeting.is_none t.meeting then None else Some (t.meeting.number + 1))
  else None

let tell_lit t light ~has_way =
  match t.observe with
  | None -> ()
  | Some observe ->
      let past = passed t has_way in
      let { Light.cosine; falloff } = t.incidence
      and gives = Raw_color.create () in
      Light.add t.prepared.lights.(light - 1) t.incidence gives;
      let contribution = Raw_color.to_color gives in
      observe (Event.Lit { light; cosine; falloff; contribution; past })

(* Adds what the light of this number, from 1, gives. *)
let add t number light =
  if Light.meet light t.spot t.incidence then (
    (* there is no way to a light where the shadow ray would start *)
    let has_way = Light.aim light t.spot t.shadow_ray in
    if not (has_way && is_blocked t number) then (
      Light.add light t.incidence t.light;
      tell_lit t number ~has_way))
  else tell_facing_away t number

let gather t =
  let lights = t.prepared.lights in
  Raw_color.set t.light 0. 0. 0.;
  Spot.start t.spot t.shadow_ray;
  t.shadow_ray.seed <- t.ray.seed;
  for k = 0 to Array.length lights - 1 do
    add t (k + 1) (Array.unsafe_get lights k)
  done
