open Raylab_geometry

type t = {
  mutable x : float;
  mutable y : float;
  mutable z : float;
  mutable cosine : float;
  mutable falloff : float;
  mutable cone : float;
}

let create () =
  { x = 0.; y = 0.; z = 0.; cosine = 0.; falloff = 0.; cone = 1. }

(* A light whose distance cannot be squared gives nothing. The limit of the
   offset sees to it that the way of the shadow ray can be squared as well. *)
let[@inline] is_within_squares squared (spot : Spot.t) =
  squared > 0. && squared < Offset.farthest && spot.offset < 0x1p500

(* Both the surface and its normal for shading must face along the way (x, y,
   z), which is [length] long; the cosine is that of the latter, or of the
   surface if that alone turns away. *)
let[@inline] face t (spot : Spot.t) x y z ~length =
  let shaded =
    (spot.shading_x *. x) +. (spot.shading_y *. y) +. (spot.shading_z *. z)
  and flat = (spot.nx *. x) +. (spot.ny *. y) +. (spot.nz *. z) in
  let cosine = (if flat > 0. then shaded else flat) /. length in
  t.cosine <- cosine;
  flat > 0. && cosine > 0.

(* From the point (x, y, z). *)
let[@inline] meet_point { Light.is_unfading; _ } t (spot : Spot.t) x y z =
  t.x <- x;
  t.y <- y;
  t.z <- z;
  let wx = x -. spot.x and wy = y -. spot.y and wz = z -. spot.z in
  let squared = (wx *. wx) +. (wy *. wy) +. (wz *. wz) in
  if is_within_squares squared spot then (
    t.falloff <- (if is_unfading then 1. else Saturate.limit (1. /. squared));
    face t spot wx wy wz ~length:(sqrt squared))
  else (
    t.cosine <- 0.;
    t.falloff <- 0.;
    false)

(* Not inlined: the commoner lights have room for registers then. *)
let[@inline never] meet_spot light (beam : Beam.t) spot t =
  let { Vec3.x; y; z } = beam.position in
  let faces = meet_point light t spot x y z in
  if faces then
    t.cone <-
      Beam.part beam
        (Beam.aside beam (x -. spot.Spot.x) (y -. spot.y) (z -. spot.z))
  else t.cone <- 0.;
  faces

let[@inline never] meet_area light (pane : Pane.t) k (ray : Raw_ray.t) spot t =
  let { Pane.corner; edge; other; _ } = pane in
  let u = Pane.across pane k ~seed:ray.seed
  and v = Pane.along pane k ~seed:ray.seed in
  t.cone <- 1.;
  meet_point light t spot
    (corner.x +. (u *. edge.x) +. (v *. other.x))
    (corner.y +. (u *. edge.y) +. (v *. other.y))
    (corner.z +. (u *. edge.z) +. (v *. other.z))

let[@inline] meet (light : Light.t) k ray (spot : Spot.t) t =
  match light.source with
  | Directional along ->
      let { Vec3.x; y; z } = (along :> Vec3.t) in
      t.falloff <- 1.;
      t.cone <- 1.;
      face t spot (-.x) (-.y) (-.z) ~length:1.
  | Spherical { x; y; z } ->
      t.cone <- 1.;
      meet_point light t spot x y z
  | Spot beam -> meet_spot light beam spot t
  | Area pane -> meet_area light pane k ray spot t

(* cosine * falloff * cone * intensity * colour *)
let[@inline] add (light : Light.t) { cosine; falloff; cone; _ }
    (sum : Raw_color.t) =
  let k = Saturate.limit (cosine *. falloff) *. cone
  and { Color.r; g; b } = light.power in
  Raw_color.set sum
    (sum.r +. Saturate.limit (k *. r))
    (sum.g +. Saturate.limit (k *. g))
    (sum.b +. Saturate.limit (k *. b))

(* {1 Shadows} *)

let[@inline] aim (light : Light.t) { x; y; z; _ } (spot : Spot.t)
    (ray : Raw_ray.t) =
  match light.source with
  | Directional along ->
      let { Vec3.x; y; z } = (along :> Vec3.t) in
      Raw_ray.set_direction ray (-.x) (-.y) (-.z);
      ray.reach <- infinity;
      true
  | Spherical _ | Spot _ | Area _ ->
      let vx = x -. ray.ox and vy = y -. ray.oy and vz = z -. ray.oz in
      let way = sqrt ((vx *. vx) +. (vy *. vy) +. (vz *. vz)) in
      let scale = 1. /. way in
      Raw_ray.set_direction ray (vx *. scale) (vy *. scale) (vz *. scale);
      ray.reach <- way -. spot.offset;
      way > 0. && way < infinity

(* {1 As pure functions} *)

let ray_of seed =
  let ray = Raw_ray.create () in
  ray.seed <- seed;
  ray

let received ?(seed = 0.) light ~point ~normal =
  let t = create () and sum = Raw_color.create () and ray = ray_of seed in
  let spot = Spot.of_point ~point ~normal ~offset:0. in
  let count = Light.points light in
  for k = 0 to count - 1 do
    if meet light k ray spot t then add light t sum
  done;
  Raw_color.mean sum count;
  Raw_color.to_color sum

let shadow_ray ?(seed = 0.) ?(k = 0) light ~point ~normal ~offset =
  let t = create () and ray = ray_of seed in
  let spot = Spot.of_point ~point ~normal ~offset in
  ignore (meet light k ray spot t : bool);
  Spot.start spot ray;
  if aim light t spot ray then Some (Ray.of_raw ray) else None
