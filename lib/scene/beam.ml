open Raylab_geometry
open Raylab_expression

type t = {
  position : Vec3.t;
  target : Vec3.t;
  inner : float;
  outer : float;
  axis : Direction.t;
  full : float;
  none : float;
}

type problem = Not_finite | No_axis | Inner_beyond_outer | Not_below_180

let is_angle x = Number.broken Non_negative x = None

let make ~position ~target ~inner ~outer =
  if
    not
      (Vec3.is_finite position && Vec3.is_finite target && is_angle inner
     && is_angle outer)
  then Error Not_finite
  else if outer >= 180. then Error Not_below_180
  else if inner > outer then Error Inner_beyond_outer
  else
    match Direction.of_vec3 (Vec3.sub target position) with
    | None -> Error No_axis
    | Some axis ->
        let full = Degrees.cos inner and none = Degrees.cos outer in
        Ok { position; target; inner; outer; axis; full; none }

let tell = function
  | Not_finite -> "points and angles of a spot must be finite, angles positive"
  | No_axis -> "a spot and its target must be two points"
  | Inner_beyond_outer -> "the inner angle of a spot is beyond the outer one"
  | Not_below_180 -> "the outer angle of a spot must be less than 180"

let make_exn ~position ~target ~inner ~outer =
  match make ~position ~target ~inner ~outer with
  | Ok beam -> beam
  | Error problem -> invalid_arg (tell problem)

let[@inline] aside { axis; _ } x y z =
  let a = (axis :> Vec3.t) in
  -.((a.x *. x) +. (a.y *. y) +. (a.z *. z))
  /. sqrt ((x *. x) +. (y *. y) +. (z *. z))

let[@inline] part { full; none; _ } c =
  if c >= full then 1.
  else if c <= none then 0.
  else
    let t = (c -. none) /. (full -. none) in
    t *. t *. (3. -. (2. *. t))

let angle beam point =
  let { Vec3.x; y; z } = Vec3.sub beam.position point in
  (* where squares are subnormal it may be far beyond *)
  Arc.acos (Float.max (-1.) (Float.min 1. (aside beam x y z)))

let equal a b =
  Vec3.equal a.position b.position
  && Vec3.equal a.target b.target
  && a.inner = b.inner && a.outer = b.outer
