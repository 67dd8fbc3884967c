open Unchecked

type shear = {
  mutable ox : float;
  mutable oy : float;
  mutable oz : float;
  mutable sx : float;
  mutable sy : float;
  mutable sz : float;
  mutable distance : float; (* of what was met *)
}

(* Apart, since a record of integers and floats would box the floats. *)
type t = {
  mutable x : int; (* the axes *)
  mutable y : int;
  mutable z : int;
  shear : shear;
}

let create () =
  {
    x = 0;
    y = 1;
    z = 2;
    shear =
      { ox = 0.; oy = 0.; oz = 0.; sx = 0.; sy = 0.; sz = 1.; distance = 0. };
  }

let set t (ray : Raw_ray.t) =
  let { Raw_ray.ox; oy; oz; dx; dy; dz; _ } = ray and s = t.shear in
  let ax = abs_float dx and ay = abs_float dy and az = abs_float dz in
  if ax > ay && ax > az then (
    t.x <- 1;
    t.y <- 2;
    t.z <- 0;
    s.ox <- oy;
    s.oy <- oz;
    s.oz <- ox;
    s.sz <- 1. /. dx;
    s.sx <- dy /. dx;
    s.sy <- dz /. dx)
  else if ay > az then (
    t.x <- 2;
    t.y <- 0;
    t.z <- 1;
    s.ox <- oz;
    s.oy <- ox;
    s.oz <- oy;
    s.sz <- 1. /. dy;
    s.sx <- dz /. dy;
    s.sy <- dx /. dy)
  else (
    t.x <- 0;
    t.y <- 1;
    t.z <- 2;
    s.ox <- ox;
    s.oy <- oy;
    s.oz <- oz;
    s.sz <- 1. /. dz;
    s.sx <- dx /. dz;
    s.sy <- dy /. dz)

(* On which side of the way from P to Q the origin lies: that of [side], the
   cross product of P and Q, and where that is 0 that of a point beside the
   origin, by a little in x and by far less in y. From Q to P it is the other
   side, to the last bit. *)
let[@inline] is_left side px py qx qy =
  side > 0. || (side = 0. && (py > qy || (py = qy && qx > px)))

let[@inline] is_right side px py qx qy =
  side < 0. || (side = 0. && (py < qy || (py = qy && qx < px)))

let[@inline] meet t (points : float array) a b c =
  let { ox; oy; oz; sx; sy; sz; _ } = t.shear in
  let a = 3 * a and b = 3 * b and c = 3 * c in
  let az = points.%(a + t.z) -. oz
  and bz = points.%(b + t.z) -. oz
  and cz = points.%(c + t.z) -. oz in
  let ax = points.%(a + t.x) -. ox -. (sx *. az)
  and ay = points.%(a + t.y) -. oy -. (sy *. az)
  and bx = points.%(b + t.x) -. ox -. (sx *. bz)
  and by = points.%(b + t.y) -. oy -. (sy *. bz)
  and cx = points.%(c + t.x) -. ox -. (sx *. cz)
  and cy = points.%(c + t.y) -. oy -. (sy *. cz) in
  let u = (bx *. cy) -. (by *. cx)
  and v = (cx *. ay) -. (cy *. ax)
  and w = (ax *. by) -. (ay *. bx) in
  if
    (is_left u bx by cx cy && is_left v cx cy ax ay && is_left w ax ay bx by)
    || is_right u bx by cx cy && is_right v cx cy ax ay
       && is_right w ax ay bx by
  then (
    let whole = u +. v +. w in
    t.shear.distance <- sz *. ((u *. az) +. (v *. bz) +. (w *. cz)) /. whole;
    (* a triangle without an area is not met *)
    whole <> 0.)
  else false

let distance t = t.shear.distance
