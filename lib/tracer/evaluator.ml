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
  Hit.of_registers ~primitive t.meeting t.spot t.ray

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

(* Puts the light that a surface with the lobes at [at] returns into [color]. *)
let diffuse t lobes at =
  let at = at + Raw_lobes.albedo in
  let r = lobes.%(at) and g = lobes.%(at + 1) and b = lobes.%(at + 2) in
  let light = t.light in
  if r > 0. || g > 0. || b > 0. then Lighting.gather t
  else Raw_color.set light 0. 0. 0.;
  Raw_color.set t.color (r *. light.r) (g *. light.g) (b *. light.b)

(* Puts the colour of the ray, with [left] rays left in its chain, into the
   register [color]. *)
let rec trace t left =
  if left > 0 && find t then (
    t.tally.hits <- t.tally.hits + 1;
    tell_hit t;
    let { Surfaces.lobes; rows; _ } = t.surfaces in
    let row = rows.(t.meeting.number) in
    if row >= 0 then shade t left lobes row else shade_part t left)
  else (
    Background.read t.background t.ray t.color;
    tell_background t left)

(* The same for a ray that hits a surface that varies, or one of many. *)
and shade_part t left =
  let { Meeting.number; part; _ } = t.meeting in
  let row = Prepared.row t.prepared ~number ~part in
  if row >= 0 then shade t left t.surfaces.lobes row
  else if row = Surfaces.varies || Surfaces.is_patterned row then (
    let surface = Prepared.surface t.prepared ~number ~part in
    Surface.write (machines t row) surface t.spot t.lobes;
    shade t left t.lobes.core 0)
  else shade t left (Surfaces.rich t.surfaces row).core 0

(* The same for a ray that hits a surface with the lobes at [at]. The mirrored
   ray uses the registers anew: what is wanted after it is read before. *)
and shade t left lobes at =
  let er = lobes.%(at + Raw_lobes.emission)
  and eg = lobes.%(at + Raw_lobes.emission + 1)
  and eb = lobes.%(at + Raw_lobes.emission + 2) in
  let kr = lobes.%(at + Raw_lobes.mirror)
  and kg = lobes.%(at + Raw_lobes.mirror + 1)
  and kb = lobes.%(at + Raw_lobes.mirror + 2) in
  diffuse t lobes at;
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
          { source = Diffused { light }; color = Color.make dr dg db };
          { source = Mirror; color = Color.make mr mg mb };
        ]
      in
      observe (Closed { left; terms; color = Raw_color.to_color t.color })

(* {1 Questions from outside} *)

let evaluate t =
  let left = t.prepared.scene.ray_depth in
  match
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
  Lighting.gather t;
  Raw_color.to_color t.light
