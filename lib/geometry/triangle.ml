type t = {
  a : Vec3.t;
  b : Vec3.t;
  c : Vec3.t;
  normal : Direction.t;
  span : float;
}

let make a b c =
  let require corner { Vec3.x; y; z } =
    Number.require Finite ("the x of corner " ^ corner) x;
    Number.require Finite ("the y of corner " ^ corner) y;
    Number.require Finite ("the z of corner " ^ corner) z
  in
  require "A" a;
  require "B" b;
  require "C" c;
  let edge = Vec3.sub b a and other = Vec3.sub c a in
  match Flat.normal edge other with
  | Some normal -> { a; b; c; normal; span = Flat.span edge other }
  | None -> invalid_arg "the corners of a triangle lie on one line"

let name = "triangle"

let parameters { a; b; c; _ } =
  [
    ("a", Parameter.of_vec3 a);
    ("b", Parameter.of_vec3 b);
    ("c", Parameter.of_vec3 c);
  ]

let corners { a; b; c; _ } = [ a; b; c ]

(* NaN if the line passes outside. *)
let[@inline] distance { a; b; c; normal; span } (ray : Raw_ray.t) =
  let ab = Flat.side ray a.x a.y a.z b.x b.y b.z
  and bc = Flat.side ray b.x b.y b.z c.x c.y c.z
  and ca = Flat.side ray c.x c.y c.z a.x a.y a.z in
  if (ab >= 0. && bc >= 0. && ca >= 0.) || (ab <= 0. && bc <= 0. && ca <= 0.)
  then Flat.distance_near a normal span ray
  else nan

let offer triangle ray meeting ~number =
  Meeting.offer meeting ray ~number ~part:0 (distance triangle ray)

let settle { a; normal; _ } ray spot = Flat.settle a normal ray spot

let crossings triangle ray crossings =
  Flat.cross (distance triangle ray) crossings

let pp ppf { a; b; c; _ } =
  Format.fprintf ppf "triangle a %a b %a c %a" Vec3.pp a Vec3.pp b Vec3.pp c
