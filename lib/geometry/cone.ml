type t = Frustum.t

let make = Frustum.make
let name = "cone"

let parameters { Frustum.a; b; radius_a; radius_b; _ } =
  [
    ("a", Parameter.of_vec3 a);
    ("radius_a", Parameter.Number radius_a);
    ("b", Parameter.of_vec3 b);
    ("radius_b", Parameter.Number radius_b);
  ]

let pp ppf { Frustum.a; b; radius_a; radius_b; _ } =
  Format.fprintf ppf "cone from %a radius %a to %a radius %a" Vec3.pp a
    Number.pp radius_a Vec3.pp b Number.pp radius_b
