type t = { factor : float; x : Vec3.t; y : Vec3.t; z : Vec3.t; way : Vec3.t }

(* [x], [y] and [z] are the rows of the rotation. *)

let identity =
  {
    factor = 1.;
    x = Vec3.make 1. 0. 0.;
    y = Vec3.make 0. 1. 0.;
    z = Vec3.make 0. 0. 1.;
    way = Vec3.zero;
  }

let scaled factor = { identity with factor }
let translated way = { identity with way }

let rotated ~(axis : Direction.t) ~sin ~cos =
  let { Vec3.x; y; z } = (axis :> Vec3.t) and rest = 1. -. cos in
  let row = Vec3.make in
  {
    identity with
    x =
      row
        (cos +. (x *. x *. rest))
        ((x *. y *. rest) -. (z *. sin))
        ((x *. z *. rest) +. (y *. sin));
    y =
      row
        ((y *. x *. rest) +. (z *. sin))
        (cos +. (y *. y *. rest))
        ((y *. z *. rest) -. (x *. sin));
    z =
      row
        ((z *. x *. rest) -. (y *. sin))
        ((z *. y *. rest) +. (x *. sin))
        (cos +. (z *. z *. rest));
  }

let factor s = s.factor
let direction { x; y; z; _ } v = Vec3.(make (dot x v) (dot y v) (dot z v))
let point s p = Vec3.add (Vec3.scale s.factor (direction s p)) s.way

let compose second first =
  let column v = direction second (direction first v) in
  let a = column (Vec3.make 1. 0. 0.)
  and b = column (Vec3.make 0. 1. 0.)
  and c = column (Vec3.make 0. 0. 1.) in
  {
    factor = second.factor *. first.factor;
    x = Vec3.make a.x b.x c.x;
    y = Vec3.make a.y b.y c.y;
    z = Vec3.make a.z b.z c.z;
    way = point second first.way;
  }

let is_along_axis { Vec3.x; y; z } =
  match List.filter (fun k -> k <> 0.) [ x; y; z ] with
  | [ _ ] -> true
  | _ -> false

let keeps_axes s = List.for_all is_along_axis [ s.x; s.y; s.z ]
