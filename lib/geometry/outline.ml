type t =
  | Ball of Sphere.t
  | Endless of Plane.t
  | Patch of Vec3.t list
  | Body of Vec3.t list list
  | Several of t list
