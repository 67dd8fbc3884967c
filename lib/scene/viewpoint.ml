open Raylab_geometry

type t = {
  eye : Vec3.t;
  look_at : Vec3.t;
  up : Vec3.t;
  right : Direction.t;
  above : Direction.t;
  forward : Direction.t;
}

type problem = At_the_eye | Along_up

let default_look_at = Vec3.zero
let default_up = Vec3.make 0. 1. 0.

let largest { Vec3.x; y; z } =
  Float.max (abs_float x) (Float.max (abs_float y) (abs_float z))

let divide k { Vec3.x; y; z } = Vec3.make (x /. k) (y /. k) (z /. k)

(* Of a vector that is not zero. By its largest number first: then no square
   leaves the range of doubles, and a vector along an axis is that axis. *)
let unit v =
  let v = divide (largest v) v in
  divide (Vec3.length v) v

(* The way, or half of it where it is too long for a double. *)
let way a b =
  let way = Vec3.sub b a in
  if Vec3.is_finite way then (1., way)
  else (2., Vec3.sub (Vec3.scale 0.5 b) (Vec3.scale 0.5 a))

let least_angle = 1e-9

let frame ~up forward =
  let across = Vec3.cross (unit up) forward in
  if Vec3.length across < least_angle then None
  else
    let right = unit across in
    (* what a small angle has left of rounding along [forward] *)
    let right =
      unit (Vec3.sub right (Vec3.scale (Vec3.dot right forward) forward))
    in
    Some (right, Vec3.cross forward right)

let require name v =
  if not (Vec3.is_finite v) then
    invalid_arg (Format.asprintf "%s %a is not finite" name Vec3.pp v)

let make ?(look_at = default_look_at) ?(up = default_up) eye =
  require "the eye" eye;
  require "the point looked at" look_at;
  require "up" up;
  if Vec3.equal up Vec3.zero then invalid_arg "up is the zero vector";
  let _, way = way eye look_at in
  if Vec3.equal way Vec3.zero then Error At_the_eye
  else
    let forward = unit way in
    match frame ~up forward with
    | None -> Error Along_up
    | Some (right, above) ->
        let direction = Direction.of_vec3_exn in
        Ok
          {
            eye;
            look_at;
            up;
            right = direction right;
            above = direction above;
            forward = direction forward;
          }

let make_exn ?look_at ?up eye =
  match make ?look_at ?up eye with
  | Ok viewpoint -> viewpoint
  | Error At_the_eye -> invalid_arg "the eye is at the point looked at"
  | Error Along_up -> invalid_arg "the eye looks along up"

let before_origin depth = make_exn (Vec3.make 0. 0. (-.depth))

let distance { eye; look_at; _ } =
  let times, way = way eye look_at in
  let size = largest way in
  times *. size *. Vec3.length (divide size way)

let to_frame { right; above; forward; _ } v =
  let along (d : Direction.t) = Vec3.dot v (d :> Vec3.t) in
  Vec3.make (along right) (along above) (along forward)

let of_frame { right; above; forward; _ } { Vec3.x; y; z } =
  let along k (d : Direction.t) = Vec3.scale k (d :> Vec3.t) in
  Vec3.add (Vec3.add (along x right) (along y above)) (along z forward)

let equal a b =
  Vec3.equal a.eye b.eye
  && Vec3.equal a.look_at b.look_at
  && Vec3.equal a.up b.up

let pp ppf { eye; look_at; up; _ } =
  Format.fprintf ppf "eye %a, lookAt %a" Vec3.pp eye Vec3.pp look_at;
  if not (Vec3.equal up default_up) then
    Format.fprintf ppf ", up %a" Vec3.pp up
