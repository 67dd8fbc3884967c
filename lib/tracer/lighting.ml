open Raylab_geometry
open Raylab_scene
open Registers

(* {1 Events}

   What is told has a number of a light, from 1, and of a point of it, from 0. *)

let lamp t number = t.prepared.lights.(number - 1)

let cell t number k =
  match (lamp t number).source with
  | Area _ -> Some (k + 1)
  | Directional _ | Spherical _ | Spot _ -> None

let tell_shadow_ray t light k =
  match t.observe with
  | None -> ()
  | Some observe ->
      let ray = Ray.of_raw t.shadow_ray in
      observe (Event.Shadow_ray { light; cell = cell t light k; ray })

(* What blocks the shadow ray is of interest to an observer only. *)
let tell_blocker t light k ~reach =
  match t.observe with
  | None -> ()
  | Some observe ->
      let { Event.by; primitive; t = at; point } = Shadow.blocker t ~reach in
      let cell = cell t light k in
      observe (Event.Blocked { light; cell; by; primitive; t = at; point })

let tell_facing_away t light k =
  match t.observe with
  | None -> ()
  | Some observe ->
      let { Incidence.cosine; _ } = t.incidence in
      observe (Event.Faces_away { light; cell = cell t light k; cosine })

let angle t beam = Beam.angle beam (Spot.point t.spot)

let tell_outside t light =
  match (t.observe, (lamp t light).source) with
  | Some observe, Spot beam ->
      observe (Event.Outside { light; angle = angle t beam })
  | _ -> ()

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

(* {1 What comes of a light} *)

(* Adds to [sum] what comes of the point of [light] that has been met. *)
let add_gift t light sum =
  if Shadow.is_tinted t then (
    Raw_color.set t.gives 0. 0. 0.;
    Incidence.add light t.incidence t.gives;
    Shadow.add t t.gives sum)
  else Incidence.add light t.incidence sum

(* The same for the highlights. *)
let add_shine t light (highlights : Raw_parts.t) shine =
  if highlights.count > 0 then
    if Shadow.is_tinted t then (
      Shine.clear t.gives_shine highlights;
      Shine.add light t.incidence t.spot t.ray highlights t.gives_shine;
      Shine.add_tinted t.gives_shine t.tint shine)
    else Shine.add light t.incidence t.spot t.ray highlights shine

let shines t light highlights =
  let gives = Shine.create () in
  Shine.clear gives highlights;
  add_shine t light highlights gives;
  Shine.colors gives

let tell_lit t light k highlights ~has_way =
  match t.observe with
  | None -> ()
  | Some observe ->
      let past = passed t has_way in
      let lamp = lamp t light and cell = cell t light k in
      let { Incidence.cosine; falloff; cone = part; _ } = t.incidence
      and gives = Raw_color.create () in
      add_gift t lamp gives;
      let contribution = Raw_color.to_color gives
      and shines = shines t lamp highlights
      and through = Shadow.crossings t in
      let cone =
        match lamp.source with
        | Spot beam -> Some { Event.angle = angle t beam; part }
        | Directional _ | Spherical _ | Area _ -> None
      in
      observe
        (Event.Lit
           {
             light;
             cell;
             cosine;
             falloff;
             cone;
             contribution;
             shines;
             past;
             through;
           })

let tell_mean t light points (highlights : Raw_parts.t) =
  match t.observe with
  | None -> ()
  | Some observe ->
      let contribution = Raw_color.to_color t.mean
      and shines =
        if highlights.count = 0 then [] else Shine.colors t.mean_shine
      in
      observe (Event.Mean { light; points; contribution; shines })

(* {1 Lights} *)

(* Whether something is in the way of the shadow ray. *)
let is_blocked t light k =
  let tally = t.tally in
  tally.shadow <- tally.shadow + 1;
  tell_shadow_ray t light k;
  let reach = t.shadow_ray.reach in
  let blocked = not (Shadow.is_seen t light) in
  if blocked then (
    tally.blocked <- tally.blocked + 1;
    tell_blocker t light k ~reach);
  t.shadow_ray.reach <- reach;
  blocked

(* Adds to [sum] what point [k] of the light of this number, from 1, gives, and
   to [shine] what it gives to the highlights. *)
let add_point t number light k highlights sum shine =
  if not (Incidence.meet light k t.shadow_ray t.spot t.incidence) then
    tell_facing_away t number k
  else if t.incidence.cone = 0. then tell_outside t number
  else
    (* there is no way to a light where the shadow ray would start *)
    let has_way = Incidence.aim light t.incidence t.spot t.shadow_ray in
    if not has_way then Shadow.reset t;
    if not (has_way && is_blocked t number k) then (
      add_gift t light sum;
      add_shine t light highlights shine;
      tell_lit t number k highlights ~has_way)

(* What several points give is their mean. *)
let add_points t number light (highlights : Raw_parts.t) points =
  let { light = sum; mean; shine; mean_shine; _ } = t in
  Raw_color.set mean 0. 0. 0.;
  if highlights.count > 0 then Shine.clear mean_shine highlights;
  for k = 0 to points - 1 do
    add_point t number light k highlights mean mean_shine
  done;
  Raw_color.mean mean points;
  Raw_color.set sum (sum.r +. mean.r) (sum.g +. mean.g) (sum.b +. mean.b);
  if highlights.count > 0 then (
    Shine.mean mean_shine points;
    Shine.add_all mean_shine shine);
  tell_mean t number points highlights

let add t number (light : Light.t) highlights =
  match light.source with
  | Directional _ | Spherical _ | Spot _ ->
      add_point t number light 0 highlights t.light t.shine
  | Area pane -> add_points t number light highlights (Pane.points pane)

let gather t (highlights : Raw_parts.t) =
  let lights = t.prepared.lights in
  let { Color.r; g; b } = t.prepared.scene.ambient in
  Raw_color.set t.light r g b;
  if highlights.count > 0 then Shine.clear t.shine highlights;
  Spot.start t.spot t.shadow_ray;
  t.shadow_ray.seed <- t.ray.seed;
  for k = 0 to Array.length lights - 1 do
    add t (k + 1) (Array.unsafe_get lights k) highlights
  done
