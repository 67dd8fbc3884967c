open Raylab_geometry
open Raylab_geometry.Unchecked
open Raylab_scene
open Registers

type t = Registers.t

let create = Registers.create
let tally t = t.tally

(* {1 Events} *)

let tell_opened t role left =
  match t.observe with
  | None -> ()
  | Some observe -> observe (Opened { role; ray = Ray.of_raw t.ray; left })

let tell_background t left =
  match t.observe with
  | None -> ()
  | Some observe ->
      let color = Raw_color.to_color t.color in
      observe
        (Closed { left; terms = [ { source = Background; color } ]; color })

let hit t =
  let { Meeting.number; part; _ } = t.meeting in
  let primitive = Prepared.primitive t.prepared ~number ~part in
  let part = Prepared.own_part t.prepared ~number ~part in
  Hit.of_registers ~primitive ~part t.meeting t.spot t.ray

let tell_hit t =
  match t.observe with None -> () | Some observe -> observe (Met (hit t))

(* {1 Hits} *)

(* Whether the ray hits anything; if so that is in its registers. *)
let find t =
  let { prepared; finder; ray; meeting; spot; _ } = t in
  finder.nearest ray meeting;
  (not (Meeting.is_none meeting))
  &&
  let shape = prepared.shapes.(meeting.number) in
  Shape.settle shape ~part:meeting.part ray spot;
  Spot.turn_to spot ray;
  Offset.lift ~usual:prepared.offset spot ray;
  true

(* {1 Rays} *)

(* Puts the light that a surface with the core at [at] returns to all sides into
   [color], and what shines in its highlights into its register. *)
let diffuse t core at (highlights : Raw_parts.t) =
  let at = at + Raw_lobes.albedo in
  let r = core.%(at) and g = core.%(at + 1) and b = core.%(at + 2) in
  let light = t.light in
  if r > 0. || g > 0. || b > 0. || highlights.count > 0 then
    Lighting.gather t highlights
  else Raw_color.set light 0. 0. 0.;
  Raw_color.set t.color (r *. light.r) (g *. light.g) (b *. light.b)

(* Where neither albedo nor highlights ask for light it is black. *)
let diffused t light : Event.source =
  let ambient =
    if Color.equal light Color.black then light else t.prepared.scene.ambient
  in
  Diffused { ambient; light }

(* The terms of what needs no ray, whose colours are in the registers. *)
let direct_terms t { Raw_lobes.core; highlights; _ } : Event.term list =
  match t.observe with
  | None -> []
  | Some _ ->
      let emitted at = core.(Raw_lobes.emission + at) in
      let shine k =
        let sharpness = highlights.numbers.(k * highlights.size) in
        {
          Event.source = Shine { sharpness; shine = Shine.color t.shine k };
          color = Shine.term t.shine highlights k;
        }
      in
      {
        source = Emitted;
        color = Color.make (emitted 0) (emitted 1) (emitted 2);
      }
      :: {
           source = diffused t (Raw_color.to_color t.light);
           color = Raw_color.to_color t.color;
         }
      :: List.init highlights.count shine

(* What the bounces from [first] on are, before they are followed. *)
let bounce_sources t { Raw_lobes.refractions; _ } ~first : Event.source list =
  match t.observe with
  | None -> []
  | Some _ ->
      let refraction part =
        let k = first + 1 + part in
        Event.Refraction
          {
            index = refractions.numbers.(part * refractions.size);
            weight = Bounces.color t.bounces k;
            share = Bounces.share t.bounces k;
            cosine = Bounces.cosine t.bounces k;
          }
      in
      Mirror { weight = Bounces.color t.bounces first }
      :: List.init refractions.count refraction

let tell_closed t left direct sources ~first =
  match t.observe with
  | None -> ()
  | Some observe ->
      let term part source =
        { Event.source; color = Bounces.color t.bounces (first + part) }
      in
      let terms = direct @ List.mapi term sources in
      observe (Closed { left; terms; color = Raw_color.to_color t.color })

let show_background t left =
  Background.read t.background t.ray t.color;
  tell_background t left

(* Puts the colour of the ray, with [left] rays left in its chain, into the
   register [color]. *)
let rec trace t left =
  if left > 0 && find t then (
    t.tally.hits <- t.tally.hits + 1;
    tell_hit t;
    let { Surfaces.lobes; rows; _ } = t.surfaces in
    let row = rows.(t.meeting.number) in
    if row >= 0 then shade t left lobes row else shade_part t left)
  else show_background t left

(* The same for a ray that hits a surface that varies, or one of many. *)
and shade_part t left =
  let { Meeting.number; part; _ } = t.meeting in
  let row = Prepared.row t.prepared ~number ~part in
  if row >= 0 then shade t left t.surfaces.lobes row
  else if row = Surfaces.varies || Surfaces.is_patterned row then (
    let surface = Prepared.surface t.prepared ~number ~part in
    Surface.write (machines t row) surface t.spot t.lobes;
    if Raw_lobes.is_plain t.lobes then shade t left t.lobes.core 0
    else shade_rich t left t.lobes)
  else shade_rich t left (Surfaces.rich t.surfaces row)

(* The same for a ray that hits a surface with the lobes at [at]. The mirrored
   ray uses the registers anew: what is wanted after it is read before. *)
and shade t left lobes at =
  let er = lobes.%(at + Raw_lobes.emission)
  and eg = lobes.%(at + Raw_lobes.emission + 1)
  and eb = lobes.%(at + Raw_lobes.emission + 2) in
  let kr = lobes.%(at + Raw_lobes.mirror)
  and kg = lobes.%(at + Raw_lobes.mirror + 1)
  and kb = lobes.%(at + Raw_lobes.mirror + 2) in
  diffuse t lobes at t.no_highlights;
  let { Raw_color.r = dr; g = dg; b = db } = t.color in
  let { Raw_color.r = lr; g = lg; b = lb } = t.light in
  if kr > 0. || kg > 0. || kb > 0. then (
    Spot.reflect t.spot t.ray;
    if left > 1 then t.tally.reflected <- t.tally.reflected + 1;
    tell_opened t Mirrored (left - 1);
    trace t (left - 1);
    let seen = t.color in
    Raw_color.set seen (kr *. seen.r) (kg *. seen.g) (kb *. seen.b))
  else Raw_color.set t.color 0. 0. 0.;
  let { Raw_color.r = mr; g = mg; b = mb } = t.color in
  Raw_color.set t.color (er +. dr +. mr) (eg +. dg +. mg) (eb +. db +. mb);
  match t.observe with
  | None -> ()
  | Some observe ->
      let light = Color.make lr lg lb in
      let terms : Event.term list =
        [
          { source = Emitted; color = Color.make er eg eb };
          { source = diffused t light; color = Color.make dr dg db };
          {
            source = Mirror { weight = Color.make kr kg kb };
            color = Color.make mr mg mb;
          };
        ]
      in
      observe (Closed { left; terms; color = Raw_color.to_color t.color })

(* The same for a surface that may send on several rays. The registers of its
   own lobes may be used anew by the rays that it sends on. *)
and shade_rich t left (lobes : Raw_lobes.t) =
  let core = lobes.core and bounces = t.bounces in
  let er = core.%(Raw_lobes.emission)
  and eg = core.%(Raw_lobes.emission + 1)
  and eb = core.%(Raw_lobes.emission + 2) in
  let highlights = lobes.highlights in
  diffuse t core 0 highlights;
  let { Raw_color.r = dr; g = dg; b = db } = t.color in
  let r = ref (er +. dr) and g = ref (eg +. dg) and b = ref (eb +. db) in
  for k = 0 to highlights.count - 1 do
    r := !r +. Shine.red t.shine highlights k;
    g := !g +. Shine.green t.shine highlights k;
    b := !b +. Shine.blue t.shine highlights k
  done;
  let direct = direct_terms t lobes and first = Bounces.count bounces in
  Bounces.add bounces lobes t.spot t.ray;
  let sources = bounce_sources t lobes ~first in
  let stop = Bounces.count bounces in
  for k = first to stop - 1 do
    if Bounces.has_weight bounces k then bounce t left k ~mirror:first
  done;
  for k = first to stop - 1 do
    r := !r +. Bounces.red bounces k;
    g := !g +. Bounces.green bounces k;
    b := !b +. Bounces.blue bounces k
  done;
  Raw_color.set t.color !r !g !b;
  tell_closed t left direct sources ~first;
  Bounces.drop_to bounces first

(* Follows bounce [k] and puts what it brings in place of its weight. *)
and bounce t left k ~mirror =
  Bounces.load t.bounces k t.ray;
  let is_faint = t.ray.share < Bounces.least_share in
  if left > 1 && not is_faint then
    if k = mirror then t.tally.reflected <- t.tally.reflected + 1
    else t.tally.refracted <- t.tally.refracted + 1;
  tell_opened t (if k = mirror then Mirrored else Refracted) (left - 1);
  if is_faint then show_background t (left - 1) else trace t (left - 1);
  Bounces.weigh t.bounces k t.color

(* {1 Questions from outside} *)

let evaluate t =
  let left = t.prepared.scene.ray_depth in
  match
    t.ray.share <- 1.;
    Bounces.drop_to t.bounces 0;
    tell_opened t Primary left;
    trace t left
  with
  | () ->
      let color = Raw_color.to_color t.color in
      (match t.observe with
      | None -> ()
      | Some observe -> observe (Done color));
      color
  | exception Stack_overflow -> raise (Chain.Too_long { ray_depth = left })

let color t r =
  load t r;
  try evaluate t
  with Pattern.Failed failure -> Unpainted.raise_ t.prepared failure

let sample t ~x ~y k =
  t.tally.primary <- t.tally.primary + 1;
  Sample_ray.aim t.prepared.scene t.prepared.centres ~x ~y k t.ray;
  try evaluate t
  with Pattern.Failed failure ->
    Unpainted.raise_ t.prepared ~pixel:(x, y) failure

let nearest_hit t r =
  load t r;
  if find t then Some (hit t) else None

let light t { Hit.point; normal; offset; _ } =
  let t = { t with spot = Spot.of_point ~point ~normal ~offset } in
  t.ray.seed <- 0.;
  Lighting.gather t t.no_highlights;
  Raw_color.to_color t.light
