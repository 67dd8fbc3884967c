type t = { cx : float; cy : float; cz : float; radius : float }

let make ~(centre : Vec3.t) ~radius =
  Number.require Finite "the x of the centre" centre.x;
  Number.require Finite "the y of the centre" centre.y;
  Number.require Finite "the z of the centre" centre.z;
  Number.require Positive "the radius" radius;
  { cx = centre.x; cy = centre.y; cz = centre.z; radius }

let name = "sphere"
let centre s = Vec3.make s.cx s.cy s.cz

(* Where along the ray the point nearest to the centre is. *)
let[@inline] middle cx cy cz (ray : Raw_ray.t) =
  ((cx -. ray.ox) *. ray.dx)
  +. ((cy -. ray.oy) *. ray.dy)
  +. ((cz -. ray.oz) *. ray.dz)

(* The square of half the length of the chord; negative for a miss. *)
let[@inline] discriminant cx cy cz radius (ray : Raw_ray.t) middle =
  let lx = cx -. ray.ox -. (middle *. ray.dx)
  and ly = cy -. ray.oy -. (middle *. ray.dy)
  and lz = cz -. ray.oz -. (middle *. ray.dz) in
  (radius *. radius) -. ((lx *. lx) +. (ly *. ly) +. (lz *. lz))

let[@inline] nearest_raw cx cy cz radius ray =
  let middle = middle cx cy cz ray in
  let discriminant = discriminant cx cy cz radius ray middle in
  (* false for NaN *)
  if discriminant >= 0. then
    let half = sqrt discriminant in
    let near = middle -. half in
    if near > 0. then near
    else
      let far = middle +. half in
      if far > 0. then far else infinity
  else infinity

let nearest { cx; cy; cz; radius } (ray : Ray.t) =
  nearest_raw cx cy cz radius (ray :> Raw_ray.t)

let intersections { cx; cy; cz; radius } (ray : Ray.t) =
  let ray = (ray :> Raw_ray.t) in
  let middle = middle cx cy cz ray in
  let discriminant = discriminant cx cy cz radius ray middle in
  if discriminant >= 0. && discriminant < infinity then
    let half = sqrt discriminant in
    [ middle -. half; middle +. half ]
  else []

let parts s =
  [ ("centre", Part.Vector (centre s)); ("radius", Part.Number s.radius) ]

let pp ppf s =
  Format.fprintf ppf "sphere centre %a radius %a" Vec3.pp (centre s) Number.pp
    s.radius

let y_axis = Direction.of_vec3_exn (Vec3.make 0. 1. 0.)
let normal s point = Direction.of_vec3_or y_axis (Vec3.sub point (centre s))
let depth s point = s.radius -. Vec3.length (Vec3.sub point (centre s))

let project s normal =
  Vec3.add (centre s) (Vec3.scale s.radius (normal : Direction.t :> Vec3.t))
