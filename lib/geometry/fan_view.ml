open Unchecked

type frame = { axes : float array; origin : float array; parallel : bool }

let frame ?source (u : Vec3.t) (v : Vec3.t) (depth : Vec3.t) =
  let { Vec3.x; y; z } = Option.value source ~default:Vec3.zero in
  {
    axes = [| u.x; u.y; u.z; v.x; v.y; v.z; depth.x; depth.y; depth.z |];
    origin = [| x; y; z |];
    parallel = Option.is_none source;
  }

type t = {
  mutable least_u : float;
  mutable most_u : float;
  mutable least_v : float;
  mutable most_v : float;
  mutable depth : float;
  mutable u : float;
  mutable v : float;
  mutable radius : float;
}

let everything () =
  {
    least_u = neg_infinity;
    most_u = infinity;
    least_v = neg_infinity;
    most_v = infinity;
    depth = 0.;
    u = 0.;
    v = 0.;
    radius = infinity;
  }

let create = everything

(* What is around the source may be anywhere. *)
let see_anywhere view =
  view.least_u <- neg_infinity;
  view.most_u <- infinity;
  view.least_v <- neg_infinity;
  view.most_v <- infinity;
  view.u <- 0.;
  view.v <- 0.;
  view.radius <- infinity

let[@inline] set_range_u view least most =
  let pad = 1e-9 *. (abs_float least +. abs_float most) in
  view.least_u <- least -. pad;
  view.most_u <- most +. pad

let[@inline] set_range_v view least most =
  let pad = 1e-9 *. (abs_float least +. abs_float most) in
  view.least_v <- least -. pad;
  view.most_v <- most +. pad

(* A shape in the ball of radius [r] whose middle is at (a, b) and at the depth
   [m]. Each number of the axes is at most 1. *)
let[@inline] see_ball_along a b m r view =
  set_range_u view (a -. r) (a +. r);
  set_range_v view (b -. r) (b +. r);
  view.depth <- m -. r;
  view.u <- a;
  view.v <- b;
  view.radius <- r

(* Whether a ball lies beyond the side of the window through which rays go that
   have the slope [side]; [a] and [side] are of the axis u or v, towards the
   outside. *)
let[@inline] is_beyond side a m r =
  a -. (side *. m) > r *. sqrt (1. +. (side *. side))

let is_beside window a b m r =
  is_beyond window.most_u a m r
  || is_beyond (-.window.least_u) (-.a) m r
  || is_beyond window.most_v b m r
  || is_beyond (-.window.least_v) (-.b) m r

(* The tangents of the ball in the plane of u and depth have the slopes
   (a m +- r sqrt (a^2 + m^2 - r^2)) / (m^2 - r^2); the picture of the ball is an
   ellipse, and the disc the one on its longer axis. *)
let[@inline] see_ball_before a b m r view =
  let scale = (m *. m) -. (r *. r) in
  let half_u = r *. sqrt ((a *. a) +. scale)
  and half_v = r *. sqrt ((b *. b) +. scale) in
  set_range_u view
    (((a *. m) -. half_u) /. scale)
    (((a *. m) +. half_u) /. scale);
  set_range_v view
    (((b *. m) -. half_v) /. scale)
    (((b *. m) +. half_v) /. scale);
  view.u <- a *. m /. scale;
  view.v <- b *. m /. scale;
  let long = r *. sqrt ((a *. a) +. (b *. b) +. scale) /. scale in
  view.radius <- long *. (1. +. 1e-9)

(* Of a ball that is not all before the source nothing is known. [false] for
   what is behind it, or beside the window. *)
let[@inline] see_ball_from ~window a b m r view =
  if m > 1.01 *. r then (
    view.depth <- m -. r;
    see_ball_before a b m r view;
    true)
  else if m <= -.r || is_beside window a b m r then false
  else (
    view.depth <- 0.;
    see_anywhere view;
    true)

let[@inline] along (axes : float array) at x y z =
  (x *. axes.%(at)) +. (y *. axes.%(at + 1)) +. (z *. axes.%(at + 2))

let see_ball { axes; origin; parallel } (balls : float array) place ~margin
    ~window view =
  let at = 4 * place in
  let x = balls.%(at) -. origin.%(0)
  and y = balls.%(at + 1) -. origin.%(1)
  and z = balls.%(at + 2) -. origin.%(2) in
  let r = (balls.%(at + 3) *. (1. +. 1e-9)) +. margin in
  let a = along axes 0 x y z and b = along axes 3 x y z in
  let m = along axes 6 x y z in
  if parallel then (
    see_ball_along a b m r view;
    true)
  else see_ball_from ~window a b m r view

(* The rectangle around the corners of a box, each seen from the source. *)
let see_corners a b m (x : float array) view =
  let least_u = ref infinity and most_u = ref neg_infinity in
  let least_v = ref infinity and most_v = ref neg_infinity in
  for corner = 0 to 7 do
    let sign k = if (corner lsr k) land 1 = 0 then -1. else 1. in
    let sx = sign 0 and sy = sign 1 and sz = sign 2 in
    let depth = m +. (sx *. x.(6)) +. (sy *. x.(7)) +. (sz *. x.(8)) in
    let u = (a +. (sx *. x.(0)) +. (sy *. x.(1)) +. (sz *. x.(2))) /. depth
    and v = (b +. (sx *. x.(3)) +. (sy *. x.(4)) +. (sz *. x.(5))) /. depth in
    if u < !least_u then least_u := u;
    if u > !most_u then most_u := u;
    if v < !least_v then least_v := v;
    if v > !most_v then most_v := v
  done;
  set_range_u view !least_u !most_u;
  set_range_v view !least_v !most_v

let disc_around_rectangle view =
  let u = view.most_u -. view.least_u and v = view.most_v -. view.least_v in
  view.u <- view.least_u +. (0.5 *. u);
  view.v <- view.least_v +. (0.5 *. v);
  view.radius <- 0.5 *. sqrt ((u *. u) +. (v *. v)) *. (1. +. 1e-9)

(* Whether a box of these reaches lies beyond a side of the window: as for a
   ball, whose radius is how far it reaches across that side. *)
let is_box_beside window a b m (reaches : float array) =
  let beyond side a at =
    let reach k = abs_float (reaches.(at + k) -. (side *. reaches.(6 + k))) in
    a -. (side *. m) > reach 0 +. reach 1 +. reach 2
  in
  beyond window.most_u a 0 || beyond window.most_v b 3
  ||
  let beyond_other side a at =
    let reach k = abs_float (reaches.(at + k) -. (side *. reaches.(6 + k))) in
    (side *. m) -. a > reach 0 +. reach 1 +. reach 2
  in
  beyond_other window.least_u a 0 || beyond_other window.least_v b 3

let see_box_from ~window a b m reaches ~thick view =
  if m -. thick > 0.01 *. thick then (
    view.depth <- m -. thick;
    see_corners a b m reaches view;
    disc_around_rectangle view;
    true)
  else if m +. thick <= 0. || is_box_beside window a b m reaches then false
  else (
    view.depth <- 0.;
    see_anywhere view;
    true)

let see_box { axes; origin; parallel } (boxes : float array) place ~margin
    ~window view =
  let at = 6 * place in
  let middle k = 0.5 *. (boxes.(at + (2 * k)) +. boxes.(at + (2 * k) + 1))
  and half k =
    (0.5 *. (boxes.(at + (2 * k) + 1) -. boxes.(at + (2 * k)))) +. margin
  in
  let x = middle 0 -. origin.(0)
  and y = middle 1 -. origin.(1)
  and z = middle 2 -. origin.(2) in
  (* how far the half sides reach along each axis *)
  let reaches = Array.init 9 (fun k -> axes.(k) *. half (k mod 3)) in
  let reach at =
    abs_float reaches.(at)
    +. abs_float reaches.(at + 1)
    +. abs_float reaches.(at + 2)
  in
  let a = along axes 0 x y z and b = along axes 3 x y z in
  let m = along axes 6 x y z in
  let thick = reach 6 in
  if parallel then (
    set_range_u view (a -. reach 0) (a +. reach 0);
    set_range_v view (b -. reach 3) (b +. reach 3);
    view.depth <- m -. thick;
    disc_around_rectangle view;
    true)
  else see_box_from ~window a b m reaches ~thick view

(* Numbers too small to be squared divide by 0. *)
let is_finite { least_u; most_u; least_v; most_v; u; v; radius; _ } =
  abs_float least_u < infinity
  && abs_float most_u < infinity
  && abs_float least_v < infinity
  && abs_float most_v < infinity
  && abs_float u < infinity
  && abs_float v < infinity
  && radius < infinity

(* Whether anything is left. *)
let cut view window =
  if view.least_u < window.least_u then view.least_u <- window.least_u;
  if view.most_u > window.most_u then view.most_u <- window.most_u;
  if view.least_v < window.least_v then view.least_v <- window.least_v;
  if view.most_v > window.most_v then view.most_v <- window.most_v;
  view.least_u <= view.most_u && view.least_v <= view.most_v

let see frame (leaves : Leaves.t) place ~margin ~window view =
  let is_before =
    if Leaves.is_ball leaves place then
      see_ball frame leaves.balls place ~margin ~window view
    else see_box frame leaves.boxes place ~margin ~window view
  in
  is_before
  &&
  (if not (is_finite view) then see_anywhere view;
   cut view window)
