open Unchecked

type t = { cx : float; cy : float; cz : float; radius : float }

let make ~(centre : Vec3.t) ~radius =
  Number.require Finite "the x of the centre" centre.x;
  Number.require Finite "the y of the centre" centre.y;
  Number.require Finite "the z of the centre" centre.z;
  Number.require Positive "the radius" radius;
  { cx = centre.x; cy = centre.y; cz = centre.z; radius }

let name = "sphere"
let centre s = Vec3.make s.cx s.cy s.cz

let box { cx; cy; cz; radius = r } =
  Box3.make
    ~low:(Vec3.make (cx -. r) (cy -. r) (cz -. r))
    ~high:(Vec3.make (cx +. r) (cy +. r) (cz +. r))

(* Along an axis an ellipsoid reaches as far as the row of the matrix is long,
   for a ball of radius 1; wider by more than the rounding errors of what lies
   on it. *)
let box_through (out : Affine.t) { cx; cy; cz; radius } =
  let { Vec3.x; y; z } = Affine.point out (Vec3.make cx cy cz) in
  let far x a b c =
    let length = Vec3.length (Vec3.make a b c) in
    (radius *. length) +. (0x1p-44 *. (abs_float x +. (radius *. length)))
  in
  let fx = far x out.xx out.xy out.xz
  and fy = far y out.yx out.yy out.yz
  and fz = far z out.zx out.zy out.zz in
  Box3.make
    ~low:(Vec3.make (x -. fx) (y -. fy) (z -. fz))
    ~high:(Vec3.make (x +. fx) (y +. fy) (z +. fz))

(* The corners, edges and faces of a cube that is cut into pieces, brought to
   the sphere. *)
let rim { cx; cy; cz; radius } =
  let pieces = 6 in
  let steps =
    List.init (pieces + 1) (fun k ->
        (2. *. float_of_int k /. float_of_int pieces) -. 1.)
  in
  let face u v =
    [
      (u, v, 1.); (u, v, -1.); (u, 1., v); (u, -1., v); (1., u, v); (-1., u, v);
    ]
  in
  let on_sphere (x, y, z) =
    let scale = radius /. Vec3.length (Vec3.make x y z) in
    Vec3.make (cx +. (scale *. x)) (cy +. (scale *. y)) (cz +. (scale *. z))
  in
  List.concat_map (fun u -> List.concat_map (face u) steps) steps
  |> List.sort_uniq compare |> List.map on_sphere

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

let[@inline] offer_numbers cx cy cz radius ray meeting ~number =
  let middle = middle cx cy cz ray in
  let discriminant = discriminant cx cy cz radius ray middle in
  (* false for NaN *)
  if discriminant >= 0. then
    let half = sqrt discriminant in
    let near = middle -. half in
    let t = if near > 0. then near else middle +. half in
    Meeting.offer meeting ray ~number ~part:0 t

let[@inline] offer { cx; cy; cz; radius } ray meeting ~number =
  offer_numbers cx cy cz radius ray meeting ~number

let[@inline] offer_row rows place ray meeting ~number =
  let at = 4 * place in
  offer_numbers rows.%(at)
    rows.%(at + 1)
    rows.%(at + 2)
    rows.%(at + 3)
    ray meeting ~number

let crossings { cx; cy; cz; radius } ray crossings =
  let middle = middle cx cy cz ray in
  let discriminant = discriminant cx cy cz radius ray middle in
  Crossings.clear crossings ~starts_inside:false;
  if discriminant >= 0. && discriminant < infinity then (
    let half = sqrt discriminant in
    Crossings.add crossings ~part:0 (middle -. half);
    Crossings.add crossings ~part:0 (middle +. half))

(* The end of the ray carries the rounding errors of origin and distance; the
   point of the sphere nearest to it only those of the sphere. *)
let settle { cx; cy; cz; radius } ray (spot : Spot.t) =
  let x = Raw_ray.end_x ray
  and y = Raw_ray.end_y ray
  and z = Raw_ray.end_z ray in
  let vx = x -. cx and vy = y -. cy and vz = z -. cz in
  let squared = (vx *. vx) +. (vy *. vy) +. (vz *. vz) in
  if squared > 0. && squared < infinity then (
    let scale = 1. /. sqrt squared in
    let nx = vx *. scale and ny = vy *. scale and nz = vz *. scale in
    let x = cx +. (radius *. nx)
    and y = cy +. (radius *. ny)
    and z = cz +. (radius *. nz) in
    Spot.set_normal spot nx ny nz;
    Spot.set_point spot x y z;
    Spot.set_own spot x y z)
  else (
    Spot.set_normal spot ray.dx ray.dy ray.dz;
    Spot.set_point spot x y z;
    Spot.set_own spot x y z);
  spot.size <- radius

let parameters s =
  [
    ("centre", Parameter.of_vec3 (centre s));
    ("radius", Parameter.Number s.radius);
  ]

let pp ppf s =
  Format.fprintf ppf "sphere centre %a radius %a" Vec3.pp (centre s) Number.pp
    s.radius

let depth s point = s.radius -. Vec3.length (Vec3.sub point (centre s))
