type t = { point : Vec3.t; normal : Direction.t }

let make ~(point : Vec3.t) ~normal =
  Number.require Finite "the x of the point" point.x;
  Number.require Finite "the y of the point" point.y;
  Number.require Finite "the z of the point" point.z;
  { point; normal }

let name = "plane"

let parts { point; normal } =
  [ ("point", Part.Vector point); ("normal", Part.Vector (normal :> Vec3.t)) ]

(* The distance at which the line meets the plane. For a parallel line it is
   infinite, or NaN if the line lies in the plane. *)
let[@inline] distance px py pz nx ny nz (ray : Raw_ray.t) =
  let height =
    ((px -. ray.ox) *. nx) +. ((py -. ray.oy) *. ny) +. ((pz -. ray.oz) *. nz)
  and approach = (ray.dx *. nx) +. (ray.dy *. ny) +. (ray.dz *. nz) in
  height /. approach

let[@inline] nearest_raw px py pz nx ny nz ray =
  let t = distance px py pz nx ny nz ray in
  (* false for NaN *)
  if t > 0. then t else infinity

let intersections { point = p; normal } (ray : Ray.t) =
  let n = (normal :> Vec3.t) in
  let t = distance p.x p.y p.z n.x n.y n.z (ray :> Raw_ray.t) in
  if Float.is_finite t then [ t ] else []

let nearest { point = p; normal } (ray : Ray.t) =
  let n = (normal :> Vec3.t) in
  nearest_raw p.x p.y p.z n.x n.y n.z (ray :> Raw_ray.t)

(* Nine digits, and nothing where only rounding errors are left. *)
let rounded ~least x =
  if Float.abs x < least then 0. else float_of_string (Printf.sprintf "%.9g" x)

let place { point; normal } =
  let n = (normal :> Vec3.t) in
  let tiny = 1e-12 in
  let numbers =
    [|
      rounded ~least:tiny n.x;
      rounded ~least:tiny n.y;
      rounded ~least:tiny n.z;
      rounded ~least:(tiny *. Vec3.length point) (Vec3.dot n point);
    |]
  in
  (* of the two normals the one whose first number is positive *)
  match Array.find_opt (fun x -> x <> 0.) numbers with
  | Some first when first < 0. -> Array.map (fun x -> 0. -. x) numbers
  | _ -> numbers

let pp ppf { point; normal } =
  Format.fprintf ppf "plane point %a normal %a" Vec3.pp point Direction.pp
    normal
