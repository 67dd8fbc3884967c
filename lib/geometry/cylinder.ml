type t = Frustum.t

let make a b ~radius =
  Number.require Positive "the radius" radius;
  Frustum.make a radius b radius

let name = "cylinder"

let parameters { Frustum.a; b; radius_a; _ } =
  [
    ("a", Parameter.of_vec3 a);
    ("b", Parameter.of_vec3 b);
    ("radius", Parameter.Number radius_a);
  ]

let pp ppf { Frustum.a; b; radius_a; _ } =
  Format.fprintf ppf "cylinder from %a to %a radius %a" Vec3.pp a Vec3.pp b
    Number.pp radius_a
