open Raylab_geometry
open Raylab_geometry.Unchecked
open Raylab_scene
open Registers

let[@inline] is_tinted t = Option.is_some t.clear_finder

(* {1 What light goes through} *)

(* Where the passing ray, whose reach ends at a shape, meets it. *)
let settle t ~number ~part =
  let { prepared; passing; shadow_spot = spot; _ } = t in
  Shape.settle prepared.shapes.(number) ~part passing spot;
  Spot.turn_to spot passing;
  Offset.lift ~usual:prepared.offset spot passing

let lobes t ~number ~part =
  let row = Prepared.row t.prepared ~number ~part in
  if row >= 0 then None
  else if row = Surfaces.varies || Surfaces.is_patterned row then (
    let surface = Prepared.surface t.prepared ~number ~part in
    Surface.write (machines t row) surface t.shadow_spot t.shadow_lobes;
    Some t.shadow_lobes)
  else Some (Surfaces.rich t.surfaces row)

(* The cosine of the passing ray and the normal that faces it. *)
let[@inline] cosine t =
  let { Spot.shading_x = nx; shading_y = ny; shading_z = nz; _ } =
    t.shadow_spot
  and ray = t.passing in
  let c = -.((nx *. ray.dx) +. (ny *. ray.dy) +. (nz *. ray.dz)) in
  if c > 1. then 1. else if c > 0. then c else 0.

(* Puts what the surface lets through of light into the register [part]. *)
let let_through t { Raw_lobes.refractions = { numbers; size; count }; _ } =
  let part = t.part and c = cosine t in
  Raw_color.set part 0. 0. 0.;
  for k = 0 to count - 1 do
    let at = k * size in
    let through = 1. -. Refraction.share_from_outside ~index:numbers.%(at) c
    and plain = at + Raw_lobes.plain
    and glass = at + Raw_lobes.glass in
    Raw_color.set part
      (part.r +. numbers.%(plain) +. (through *. numbers.%(glass)))
      (part.g +. numbers.%(plain + 1) +. (through *. numbers.%(glass + 1)))
      (part.b +. numbers.%(plain + 2) +. (through *. numbers.%(glass + 2)))
  done

let obstacle t ~number ~part ~distance : Event.obstacle =
  {
    by = number + 1;
    primitive = Prepared.primitive t.prepared ~number ~part;
    t = distance;
    point = Spot.point t.shadow_spot;
  }

(* How far it has gone in all, along the shadow ray; its square may be no
   double. *)
let distance t =
  let { Spot.x; y; z; _ } = t.shadow_spot and ray = t.shadow_ray in
  let x = abs_float (x -. ray.ox)
  and y = abs_float (y -. ray.oy)
  and z = abs_float (z -. ray.oz) in
  let most = Float.max x (Float.max y z) in
  if most = 0. then 0.
  else
    let part = Vec3.make (x /. most) (y /. most) (z /. most) in
    Saturate.limit (most *. Vec3.length part)

let note t ~number ~part =
  if Option.is_some t.observe then
    let met = obstacle t ~number ~part ~distance:(distance t) in
    let crossing = { Event.met; part = Raw_color.to_color t.part } in
    t.crossings <- crossing :: t.crossings

let[@inline] is_black { Raw_color.r; g; b } = not (r > 0. || g > 0. || b > 0.)
let most_crossings = 1000

(* The tint of the passing ray at its next meeting, and so on to its end, at most
   [left] times: where doubles end a ray might go on forever. *)
let rec pass t (finder : Finder.t) left =
  let { passing; meeting; tint; part; _ } = t in
  let reach = passing.reach in
  finder.nearest passing meeting;
  Meeting.is_none meeting
  ||
  let number = Prepared.clear_number t.prepared meeting.number
  and met = meeting.part in
  settle t ~number ~part:met;
  (match lobes t ~number ~part:met with
  | None -> Raw_color.set part 0. 0. 0.
  | Some lobes -> let_through t lobes);
  Raw_color.set tint (tint.r *. part.r) (tint.g *. part.g) (tint.b *. part.b);
  note t ~number ~part:met;
  Spot.start_behind t.shadow_spot passing;
  passing.reach <- reach -. passing.reach;
  left > 0 && (not (is_black tint)) && pass t finder (left - 1)

let reset t =
  Raw_color.set t.tint 1. 1. 1.;
  t.crossings <- []

let start t =
  let { passing; shadow_ray = ray; _ } = t in
  reset t;
  Raw_ray.set_origin passing ray.ox ray.oy ray.oz;
  Raw_ray.set_direction passing ray.dx ray.dy ray.dz;
  passing.reach <- ray.reach

let is_seen t light =
  match t.clear_finder with
  | None -> not (t.shadow_finder.blocked light t.shadow_ray)
  | Some finder ->
      start t;
      (not (t.shadow_finder.blocked light t.shadow_ray))
      && pass t finder most_crossings

let add t (gives : Raw_color.t) (sum : Raw_color.t) =
  let tint = t.tint in
  Raw_color.set sum
    (sum.r +. Saturate.limit (gives.r *. tint.r))
    (sum.g +. Saturate.limit (gives.g *. tint.g))
    (sum.b +. Saturate.limit (gives.b *. tint.b))

(* {1 For observers} *)

(* What lets nothing through at all, or the last of what was crossed. *)
let blocker t ~reach =
  let { shadow_ray = ray; meeting; _ } = t in
  (* the answer may have shortened the ray *)
  ray.reach <- reach;
  t.shadow_finder.nearest ray meeting;
  match t.crossings with
  | { met; _ } :: _ when Meeting.is_none meeting -> met
  | _ ->
      let { Vec3.x; y; z } = Ray.at (Ray.of_raw ray) ray.reach in
      let number = Prepared.caster t.prepared meeting.number in
      {
        by = number + 1;
        primitive = Prepared.primitive t.prepared ~number ~part:meeting.part;
        t = ray.reach;
        point = Offset.(Vec3.make (within x) (within y) (within z));
      }

let crossings t = List.rev t.crossings
