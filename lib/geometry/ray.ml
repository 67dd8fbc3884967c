type t = Raw_ray.t

let[@inline] flat (o : Vec3.t) (d : Direction.t) reach =
  let d = (d :> Vec3.t) in
  {
    Raw_ray.ox = o.x;
    oy = o.y;
    oz = o.z;
    dx = d.x;
    dy = d.y;
    dz = d.z;
    reach;
    seed = 0.;
    share = 1.;
  }

let make ~origin ~direction = flat origin direction infinity

let towards ~origin ~target ~short =
  let way = Vec3.sub target origin in
  let with_direction direction =
    (* the length of [way], but squaring that might overflow *)
    let length = Vec3.dot way (direction : Direction.t :> Vec3.t) in
    flat origin direction (length -. short)
  in
  Option.map with_direction (Direction.of_vec3 way)

let of_raw (register : Raw_ray.t) = { register with ox = register.ox }
let to_raw = of_raw
let origin (ray : t) = Vec3.make ray.ox ray.oy ray.oz
let reach (ray : t) = ray.reach
let seed (ray : t) = ray.seed
let share (ray : t) = ray.share

(* The only way in is [flat], so the length is still 1. *)
let direction (ray : t) =
  Direction.of_vec3_exn (Vec3.make ray.dx ray.dy ray.dz)

let[@inline] at (ray : t) t =
  Vec3.make
    (ray.ox +. (t *. ray.dx))
    (ray.oy +. (t *. ray.dy))
    (ray.oz +. (t *. ray.dz))

let reflect ray ~point ~normal =
  let mirrored = to_raw ray in
  Spot.reflect (Spot.of_point ~point ~normal ~offset:0.) mirrored;
  mirrored

let pp ppf (ray : t) =
  Format.fprintf ppf "%a + t %a" Vec3.pp (origin ray) Direction.pp
    (direction ray);
  if ray.reach < infinity then
    Format.fprintf ppf ", t < %a" Number.pp ray.reach
