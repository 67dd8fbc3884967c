type t = { centre : Vec3.t; normal : Direction.t; radius : float }

let make ~(centre : Vec3.t) ~normal ~radius =
  Number.require Finite "the x of the centre" centre.x;
  Number.require Finite "the y of the centre" centre.y;
  Number.require Finite "the z of the centre" centre.z;
  Number.require Positive "the radius" radius;
  { centre; normal; radius }

let name = "disc"

let parameters { centre; normal; radius } =
  [
    ("centre", Parameter.of_vec3 centre);
    ("normal", Parameter.of_vec3 (normal :> Vec3.t));
    ("radius", Parameter.Number radius);
  ]

let box { centre; normal; radius } = Round.box [ (centre, radius) ] normal

let[@inline] distance { centre = c; normal; radius } (ray : Raw_ray.t) =
  let t = Flat.distance c normal ray in
  let x = ray.ox +. (t *. ray.dx) -. c.x
  and y = ray.oy +. (t *. ray.dy) -. c.y
  and z = ray.oz +. (t *. ray.dz) -. c.z in
  if (x *. x) +. (y *. y) +. (z *. z) < radius *. radius then t else nan

let offer disc ray meeting ~number =
  Meeting.offer meeting ray ~number ~part:0 (distance disc ray)

let settle { centre; normal; _ } ray spot = Flat.settle centre normal ray spot
let crossings disc ray crossings = Flat.cross (distance disc ray) crossings

let place { centre; normal; radius } =
  Array.append (Round.place [ (centre, radius) ]) (Plane.heading normal)

let pp ppf { centre; normal; radius } =
  Format.fprintf ppf "disc centre %a normal %a radius %a" Vec3.pp centre
    Direction.pp normal Number.pp radius
