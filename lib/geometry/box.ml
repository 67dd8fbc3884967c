type t = { low : Vec3.t; high : Vec3.t }

let make ~(corner : Vec3.t) ~(opposite : Vec3.t) =
  let require axis x x' =
    Number.require Finite (Printf.sprintf "the %s of a corner" axis) x;
    Number.require Finite (Printf.sprintf "the %s of a corner" axis) x';
    if x = x' then
      invalid_arg
        (Printf.sprintf "both corners of the box have %s = %g" axis x)
  in
  require "x" corner.x opposite.x;
  require "y" corner.y opposite.y;
  require "z" corner.z opposite.z;
  let each f =
    Vec3.make (f corner.x opposite.x) (f corner.y opposite.y)
      (f corner.z opposite.z)
  in
  { low = each Float.min; high = each Float.max }

let name = "box"

let parameters { low; high } =
  [ ("low", Parameter.of_vec3 low); ("high", Parameter.of_vec3 high) ]

let box { low; high } = Box3.make ~low ~high

(* {1 What is hit} *)

(* A coordinate at which the line enters or leaves a pair of faces. For a line
   along them it is infinite, or NaN if the line lies in the face. *)
let[@inline] near low high o d = ((if d < 0. then high else low) -. o) /. d
let[@inline] far low high o d = ((if d < 0. then low else high) -. o) /. d

(* A line in a face is limited by others. *)
let[@inline] later (a : float) b = if b > a then b else a
let[@inline] sooner (a : float) b = if b < a then b else a

(* The first pair of faces of which this is the distance, and the one of it. *)
let[@inline] face_in (t : float) x y dx dy dz =
  if t = x then Bool.to_int (dx < 0.)
  else if t = y then 2 + Bool.to_int (dy < 0.)
  else 4 + Bool.to_int (dz < 0.)

let crossings { low; high } (ray : Raw_ray.t) crossings =
  let { Raw_ray.ox; oy; oz; dx; dy; dz; _ } = ray in
  (* -0 would turn the signs of what is divided by it *)
  let dx = dx +. 0. and dy = dy +. 0. and dz = dz +. 0. in
  let near_x = near low.x high.x ox dx
  and near_y = near low.y high.y oy dy
  and near_z = near low.z high.z oz dz
  and far_x = far low.x high.x ox dx
  and far_y = far low.y high.y oy dy
  and far_z = far low.z high.z oz dz in
  (* negated, the constants are floats in registers, like all else here *)
  let enters = later (later (later (-.infinity) near_x) near_y) near_z
  and leaves = sooner (sooner (sooner (-.neg_infinity) far_x) far_y) far_z in
  Crossings.clear crossings ~starts_inside:false;
  let sum = ox +. oy +. oz +. dx +. dy +. dz in
  let is_line = not (Float.is_nan sum) in
  if is_line && enters <= leaves && enters > neg_infinity && leaves < infinity
  then (
    Crossings.add crossings
      ~part:(face_in enters near_x near_y dx dy dz)
      enters;
    Crossings.add crossings
      ~part:(1 lxor face_in leaves far_x far_y dx dy dz)
      leaves)

let[@inline] offer box ray (meeting : Meeting.t) ~number =
  crossings box ray meeting.room;
  Meeting.offer_room meeting ray ~number

let[@inline] within low high (x : float) =
  if x < low then low else if x > high then high else x

let[@inline] face low high part low_part x =
  if part = low_part then low
  else if part = low_part + 1 then high
  else within low high x

let settle { low; high } ~part ray (spot : Spot.t) =
  let x = face low.x high.x part 0 (Raw_ray.end_x ray)
  and y = face low.y high.y part 2 (Raw_ray.end_y ray)
  and z = face low.z high.z part 4 (Raw_ray.end_z ray) in
  let outward = if part land 1 = 0 then -1. else 1. in
  Spot.set_normal spot
    (if part lsr 1 = 0 then outward else 0.)
    (if part lsr 1 = 1 then outward else 0.)
    (if part lsr 1 = 2 then outward else 0.);
  Spot.set_point spot x y z;
  Spot.set_own spot x y z;
  spot.size <- 0.

let depth { low; high } (p : Vec3.t) =
  let least low high x = Float.min (x -. low) (high -. x) in
  Float.min (least low.x high.x p.x)
    (Float.min (least low.y high.y p.y) (least low.z high.z p.z))

(* {1 What is told} *)

let part = function
  | 0 -> "left side"
  | 1 -> "right side"
  | 2 -> "bottom"
  | 3 -> "top"
  | 4 -> "front"
  | _ -> "back"

let corners { low; high } =
  let at_height y =
    [
      Vec3.make low.x y low.z;
      Vec3.make high.x y low.z;
      Vec3.make high.x y high.z;
      Vec3.make low.x y high.z;
    ]
  in
  at_height low.y @ at_height high.y

let pp ppf b = Format.fprintf ppf "box %a to %a" Vec3.pp b.low Vec3.pp b.high
