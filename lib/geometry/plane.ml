type t = { point : Vec3.t; normal : Direction.t }

let make ~(point : Vec3.t) ~normal =
  Number.require Finite "the x of the point" point.x;
  Number.require Finite "the y of the point" point.y;
  Number.require Finite "the z of the point" point.z;
  { point; normal }

let name = "plane"

let parameters { point; normal } =
  [
    ("point", Parameter.of_vec3 point);
    ("normal", Parameter.of_vec3 (normal :> Vec3.t));
  ]

let[@inline] approach (n : Vec3.t) (ray : Raw_ray.t) =
  (ray.dx *. n.x) +. (ray.dy *. n.y) +. (ray.dz *. n.z)

let[@inline] distance { point; normal } ray = Flat.distance point normal ray

let[@inline] offer plane ray meeting ~number =
  Meeting.offer meeting ray ~number ~part:0 (distance plane ray)

(* Of a line along the plane it is the origin that tells on which side all of
   it lies. *)
let crossings ({ point; normal } as plane) (ray : Raw_ray.t) crossings =
  let n = (normal :> Vec3.t) in
  let t = distance plane ray and approach = approach n ray in
  let is_met = Float.is_finite t in
  let starts_inside =
    if is_met then approach > 0.
    else
      let origin = Vec3.make ray.ox ray.oy ray.oz in
      Vec3.dot (Vec3.sub origin point) n < 0.
  in
  Crossings.clear crossings ~starts_inside;
  if is_met then Crossings.add crossings ~part:0 t

let depth { point; normal } p = Vec3.dot (Vec3.sub point p) (normal :> Vec3.t)

let settle { point = p; normal } ray (spot : Spot.t) =
  let n = (normal :> Vec3.t) in
  let x = Raw_ray.end_x ray
  and y = Raw_ray.end_y ray
  and z = Raw_ray.end_z ray in
  Spot.set_normal spot n.x n.y n.z;
  Spot.set_point spot x y z;
  Spot.set_own spot
    (if Flat.is_across n.y n.z then p.x else x)
    (if Flat.is_across n.z n.x then p.y else y)
    (if Flat.is_across n.x n.y then p.z else z);
  spot.size <- 0.

(* Nine digits, and nothing where only rounding errors are left. *)
let rounded ~least x =
  if Float.abs x < least then 0. else float_of_string (Printf.sprintf "%.9g" x)

let tiny = 1e-12

(* Of the two ways the one whose first number is positive. *)
let either_way numbers =
  match Array.find_opt (fun x -> x <> 0.) numbers with
  | Some first when first < 0. -> Array.map (fun x -> 0. -. x) numbers
  | _ -> numbers

let heading_and (normal : Direction.t) rest =
  let n = (normal :> Vec3.t) in
  let round = rounded ~least:tiny in
  either_way (Array.append [| round n.x; round n.y; round n.z |] rest)

let heading normal = heading_and normal [||]

let place { point; normal } =
  let least = tiny *. Vec3.length point in
  heading_and normal [| rounded ~least (Vec3.dot (normal :> Vec3.t) point) |]

let pp ppf { point; normal } =
  Format.fprintf ppf "plane point %a normal %a" Vec3.pp point Direction.pp
    normal
