open Raylab_geometry
open Raylab_scene
open Registers

(* What blocks the shadow ray is of interest to an observer only. *)
let tell_blocker observe t light ~reach =
  let { Event.by; primitive; t; point } = Shadow.blocker t ~reach in
  observe (Event.Blocked { light; by; primitive; t; point })

(* Whether something is in the way of the shadow ray. *)
let is_blocked t light =
  let tally = t.tally in
  tally.shadow <- tally.shadow + 1;
  (match t.observe with
  | None -> ()
  | Some observe ->
      observe (Event.Shadow_ray { light; ray = Ray.of_raw t.shadow_ray }));
  let reach = t.shadow_ray.reach in
  let blocked = not (Shadow.is_seen t light) in
  if blocked then (
    tally.blocked <- tally.blocked + 1;
    match t.observe with
    | None -> ()
    | Some observe -> tell_blocker observe t light ~reach);
  t.shadow_ray.reach <- reach;
  blocked

let tell_facing_away t light =
  match t.observe with
  | None -> ()
  | Some observe ->
      observe (Event.Faces_away { light; cosine = t.incidence.cosine })

(* The first of the shadowless objects that light goes through. *)
let passed t has_way =
  let { Prepared.shadowless = numbers; shapes; _ } = t.prepared in
  if has_way && numbers <> [||] then (
    let finder =
      Index.ask (Index.brute_force (Array.map (Array.get shapes) numbers))
    and reach = t.shadow_ray.reach in
    finder.nearest t.shadow_ray t.meeting;
    t.shadow_ray.reach <- reach;
    if Meeting.is_none t.meeting then None
    else Some (numbers.(t.meeting.number) + 1))
  else None

(* Adds to [sum] what comes of [light]. *)
let add_gift t light sum =
  if Shadow.is_tinted t then (
    Raw_color.set t.gives 0. 0. 0.;
    Light.add light t.incidence t.gives;
    Shadow.add t t.gives sum)
  else Light.add light t.incidence sum

let tell_lit t light ~has_way =
  match t.observe with
  | None -> ()
  | Some observe ->
      let past = passed t has_way in
      let { Light.cosine; falloff } = t.incidence
      and gives = Raw_color.create () in
      add_gift t t.prepared.lights.(light - 1) gives;
      let contribution = Raw_color.to_color gives
      and through = Shadow.crossings t in
      observe
        (Event.Lit { light; cosine; falloff; contribution; past; through })

(* Adds what the light of this number, from 1, gives. *)
let add t number light =
  if Light.meet light t.spot t.incidence then (
    (* there is no way to a light where the shadow ray would start *)
    let has_way = Light.aim light t.spot t.shadow_ray in
    if not has_way then Shadow.reset t;
    if not (has_way && is_blocked t number) then (
      add_gift t light t.light;
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
