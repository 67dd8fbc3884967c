type t = { low : Vec3.t; high : Vec3.t }

let make ~(low : Vec3.t) ~(high : Vec3.t) =
  if low.x <= high.x && low.y <= high.y && low.z <= high.z then { low; high }
  else invalid_arg "a box whose low corner is not below its high one"

(* More than any rounding error of what is hit. *)
let margin = 0x1p-44

let around points =
  let least = List.fold_left Float.min infinity
  and greatest = List.fold_left Float.max neg_infinity in
  let all pick =
    Vec3.make
      (pick (List.map (fun (p : Vec3.t) -> p.x) points))
      (pick (List.map (fun (p : Vec3.t) -> p.y) points))
      (pick (List.map (fun (p : Vec3.t) -> p.z) points))
  in
  let low = all least and high = all greatest in
  let more = margin *. Float.max (Vec3.magnitude low) (Vec3.magnitude high) in
  let more = Vec3.make more more more in
  make ~low:(Vec3.sub low more) ~high:(Vec3.add high more)

let centre { low; high } = Vec3.add (Vec3.scale 0.5 low) (Vec3.scale 0.5 high)

let reach { low; high } =
  let half_x = (0.5 *. high.x) -. (0.5 *. low.x)
  and half_y = (0.5 *. high.y) -. (0.5 *. low.y)
  and half_z = (0.5 *. high.z) -. (0.5 *. low.z) in
  Float.max half_x (Float.max half_y half_z)

let pairwise f (u : Vec3.t) (v : Vec3.t) =
  Vec3.make (f u.x v.x) (f u.y v.y) (f u.z v.z)

let union a b =
  {
    low = pairwise Float.min a.low b.low;
    high = pairwise Float.max a.high b.high;
  }

let intersection a b =
  let low = pairwise Float.max a.low b.low
  and high = pairwise Float.min a.high b.high in
  if low.x <= high.x && low.y <= high.y && low.z <= high.z then
    Some { low; high }
  else None

let wider w { low; high } =
  let way = Vec3.make w w w in
  { low = Vec3.sub low way; high = Vec3.add high way }

let equal a b = Vec3.equal a.low b.low && Vec3.equal a.high b.high

let pp ppf { low; high } =
  Format.fprintf ppf "%a to %a" Vec3.pp low Vec3.pp high
