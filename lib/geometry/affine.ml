type t = {
  xx : float;
  xy : float;
  xz : float;
  yx : float;
  yy : float;
  yz : float;
  zx : float;
  zy : float;
  zz : float;
  x : float;
  y : float;
  z : float;
}

let stretched { Vec3.x; y; z } =
  {
    xx = x;
    xy = 0.;
    xz = 0.;
    yx = 0.;
    yy = y;
    yz = 0.;
    zx = 0.;
    zy = 0.;
    zz = z;
    x = 0.;
    y = 0.;
    z = 0.;
  }

let identity = stretched (Vec3.make 1. 1. 1.)
let translated { Vec3.x; y; z } = { identity with x; y; z }

let rotated ~(axis : Direction.t) ~sin ~cos =
  let { Vec3.x; y; z } = (axis :> Vec3.t) and rest = 1. -. cos in
  {
    identity with
    xx = cos +. (x *. x *. rest);
    xy = (x *. y *. rest) -. (z *. sin);
    xz = (x *. z *. rest) +. (y *. sin);
    yx = (y *. x *. rest) +. (z *. sin);
    yy = cos +. (y *. y *. rest);
    yz = (y *. z *. rest) -. (x *. sin);
    zx = (z *. x *. rest) -. (y *. sin);
    zy = (z *. y *. rest) +. (x *. sin);
    zz = cos +. (z *. z *. rest);
  }

let vector a { Vec3.x; y; z } =
  Vec3.make
    ((a.xx *. x) +. (a.xy *. y) +. (a.xz *. z))
    ((a.yx *. x) +. (a.yy *. y) +. (a.yz *. z))
    ((a.zx *. x) +. (a.zy *. y) +. (a.zz *. z))

let covector a { Vec3.x; y; z } =
  Vec3.make
    ((a.xx *. x) +. (a.yx *. y) +. (a.zx *. z))
    ((a.xy *. x) +. (a.yy *. y) +. (a.zy *. z))
    ((a.xz *. x) +. (a.yz *. y) +. (a.zz *. z))

let point a p = Vec3.add (vector a p) (Vec3.make a.x a.y a.z)

(* From columns. *)
let make (u : Vec3.t) (v : Vec3.t) (w : Vec3.t) { Vec3.x; y; z } =
  {
    xx = u.x;
    xy = v.x;
    xz = w.x;
    yx = u.y;
    yy = v.y;
    yz = w.y;
    zx = u.z;
    zy = v.z;
    zz = w.z;
    x;
    y;
    z;
  }

let columns a =
  (Vec3.make a.xx a.yx a.zx, Vec3.make a.xy a.yy a.zy, Vec3.make a.xz a.yz a.zz)

let compose second first =
  let u, v, w = columns first in
  make (vector second u) (vector second v) (vector second w)
    (point second (Vec3.make first.x first.y first.z))

let determinant a =
  let u, v, w = columns a in
  Vec3.dot u (Vec3.cross v w)

let numbers a =
  [| a.xx; a.xy; a.xz; a.yx; a.yy; a.yz; a.zx; a.zy; a.zz; a.x; a.y; a.z |]

let is_finite a = Array.for_all Float.is_finite (numbers a)

(* The rows of the inverse are the cross products of two columns each, over the
   determinant. Columns of very different lengths are brought to length 1 first,
   so that no product leaves the range of doubles. *)
let inverse a =
  let u, v, w = columns a in
  match (Direction.of_vec3 u, Direction.of_vec3 v, Direction.of_vec3 w) with
  | Some du, Some dv, Some dw when is_finite a ->
      let du = (du :> Vec3.t) and dv = (dv :> Vec3.t) in
      let dw = (dw :> Vec3.t) in
      let volume = Vec3.dot du (Vec3.cross dv dw) in
      let row column along second third =
        let length = Vec3.dot column along in
        Vec3.scale (1. /. length)
          (Vec3.scale (1. /. volume) (Vec3.cross second third))
      in
      let a' = row u du dv dw and b = row v dv dw du and c = row w dw du dv in
      let linear =
        make (Vec3.make a'.x b.x c.x) (Vec3.make a'.y b.y c.y)
          (Vec3.make a'.z b.z c.z) Vec3.zero
      in
      let { Vec3.x; y; z } =
        Vec3.neg (vector linear (Vec3.make a.x a.y a.z))
      in
      let inverse = { linear with x; y; z } in
      if is_finite inverse then Some inverse else None
  | _ -> None

(* {1 On registers} *)

let[@inline] along x y z a b c = (x *. a) +. (y *. b) +. (z *. c)

let[@inline] size { xx; xy; xz; yx; yy; yz; zx; zy; zz; _ } =
  sqrt
    (along xx xy xz xx xy xz +. along yx yy yz yx yy yz
   +. along zx zy zz zx zy zz)

let[@inline] stretch a ({ dx; dy; dz; _ } : Raw_ray.t) =
  let x = along a.xx a.xy a.xz dx dy dz
  and y = along a.yx a.yy a.yz dx dy dz
  and z = along a.zx a.zy a.zz dx dy dz in
  sqrt (along x y z x y z)

let[@inline] bring a (ray : Raw_ray.t) length =
  let { Raw_ray.ox; oy; oz; dx; dy; dz; _ } = ray and scale = 1. /. length in
  Raw_ray.set_origin ray
    (along a.xx a.xy a.xz ox oy oz +. a.x)
    (along a.yx a.yy a.yz ox oy oz +. a.y)
    (along a.zx a.zy a.zz ox oy oz +. a.z);
  Raw_ray.set_direction ray
    (scale *. along a.xx a.xy a.xz dx dy dz)
    (scale *. along a.yx a.yy a.yz dx dy dz)
    (scale *. along a.zx a.zy a.zz dx dy dz)

let bring_spot ~out ~back (ray : Raw_ray.t) (spot : Spot.t) =
  let { Spot.x; y; z; nx; ny; nz; size = own_size; _ } = spot in
  let { Spot.shading_x; shading_y; shading_z; _ } = spot in
  let is_smooth = Spot.is_smooth spot in
  let largest = size out in
  Spot.set_point spot
    (along out.xx out.xy out.xz x y z +. out.x)
    (along out.yx out.yy out.yz x y z +. out.y)
    (along out.zx out.zy out.zz x y z +. out.z);
  spot.size <-
    (largest *. (own_size +. abs_float x +. abs_float y +. abs_float z))
    +. abs_float out.x +. abs_float out.y +. abs_float out.z;
  let x = along back.xx back.yx back.zx nx ny nz
  and y = along back.xy back.yy back.zy nx ny nz
  and z = along back.xz back.yz back.zz nx ny nz in
  let squared = along x y z x y z in
  if squared > 0. && squared < infinity then
    let scale = 1. /. sqrt squared in
    Spot.set_normal spot (x *. scale) (y *. scale) (z *. scale)
  else Spot.set_normal spot ray.dx ray.dy ray.dz;
  if is_smooth then
    let nx = shading_x and ny = shading_y and nz = shading_z in
    let x = along back.xx back.yx back.zx nx ny nz
    and y = along back.xy back.yy back.zy nx ny nz
    and z = along back.xz back.yz back.zz nx ny nz in
    let squared = along x y z x y z in
    if squared > 0. && squared < infinity then
      let scale = 1. /. sqrt squared in
      Spot.set_shading_normal spot (x *. scale) (y *. scale) (z *. scale)
