let[@inline] distance (p : Vec3.t) (normal : Direction.t) (ray : Raw_ray.t) =
  let n = (normal :> Vec3.t) in
  let height =
    ((p.x -. ray.ox) *. n.x)
    +. ((p.y -. ray.oy) *. n.y)
    +. ((p.z -. ray.oz) *. n.z)
  in
  height /. ((ray.dx *. n.x) +. (ray.dy *. n.y) +. (ray.dz *. n.z))

let[@inline] distance_near (p : Vec3.t) normal span (ray : Raw_ray.t) =
  let t = distance p normal ray in
  let x = ray.ox +. (t *. ray.dx) -. p.x
  and y = ray.oy +. (t *. ray.dy) -. p.y
  and z = ray.oz +. (t *. ray.dz) -. p.z in
  if abs_float x +. abs_float y +. abs_float z <= span then t else nan

let[@inline] is_across a b = a = 0. && b = 0.

let settle (p : Vec3.t) (normal : Direction.t) ray (spot : Spot.t) =
  let n = (normal :> Vec3.t) in
  let x = Raw_ray.end_x ray
  and y = Raw_ray.end_y ray
  and z = Raw_ray.end_z ray in
  let height =
    ((x -. p.x) *. n.x) +. ((y -. p.y) *. n.y) +. ((z -. p.z) *. n.z)
  in
  (* 0 where doubles end *)
  let height = if abs_float height < infinity then height else 0. in
  let x = if is_across n.y n.z then p.x else x -. (height *. n.x)
  and y = if is_across n.z n.x then p.y else y -. (height *. n.y)
  and z = if is_across n.x n.y then p.z else z -. (height *. n.z) in
  Spot.set_normal spot n.x n.y n.z;
  Spot.set_point spot x y z;
  Spot.set_own spot x y z;
  spot.size <- 0.

let cross t crossings =
  Crossings.clear crossings ~starts_inside:false;
  if Float.is_finite t then (
    Crossings.add crossings ~part:0 t;
    Crossings.add crossings ~part:0 t)

let parallel = 1e-12

let normal u v =
  match (Direction.of_vec3 u, Direction.of_vec3 v) with
  | Some u, Some v ->
      let across = Vec3.cross (u :> Vec3.t) (v :> Vec3.t) in
      if Vec3.length across > parallel then Direction.of_vec3 across else None
  | _ -> None

let span u v = 2. *. (Vec3.magnitude u +. Vec3.magnitude v)

let[@inline] side (ray : Raw_ray.t) x y z x' y' z' =
  let px = x -. ray.ox and py = y -. ray.oy and pz = z -. ray.oz in
  let qx = x' -. ray.ox and qy = y' -. ray.oy and qz = z' -. ray.oz in
  let sx = px +. qx and sy = py +. qy and sz = pz +. qz in
  let ex = x -. x' and ey = y -. y' and ez = z -. z' in
  (ray.dx *. ((sy *. ez) -. (sz *. ey)))
  +. (ray.dy *. ((sz *. ex) -. (sx *. ez)))
  +. (ray.dz *. ((sx *. ey) -. (sy *. ex)))

(* {1 Where it is} *)

let place corners =
  List.sort compare corners
  |> List.concat_map (fun { Vec3.x; y; z } -> [ x; y; z ])
  |> Array.of_list
