type t = Sphere of Sphere.t | Plane of Plane.t

let sphere ~centre ~radius = Sphere (Sphere.make ~centre ~radius)

let plane ~point ~normal =
  Plane (Plane.make ~point ~normal:(Direction.of_vec3_exn normal))

let intersections = function
  | Sphere s -> Sphere.intersections s
  | Plane p -> Plane.intersections p

let nearest_raw shape ray =
  match shape with
  | Sphere { cx; cy; cz; radius } -> Sphere.nearest_raw cx cy cz radius ray
  | Plane { point = p; normal } ->
      let n = (normal :> Vec3.t) in
      Plane.nearest_raw p.x p.y p.z n.x n.y n.z ray

let nearest shape (ray : Ray.t) = nearest_raw shape (ray :> Raw_ray.t)

let normal shape point =
  match shape with Sphere s -> Sphere.normal s point | Plane p -> p.normal

let name = function Sphere _ -> "sphere" | Plane _ -> "plane"

let equal a b =
  match (a, b) with
  | Sphere a, Sphere b ->
      Vec3.equal (Sphere.centre a) (Sphere.centre b) && a.radius = b.radius
  | Plane a, Plane b ->
      Vec3.equal a.point b.point
      && Vec3.equal (a.normal :> Vec3.t) (b.normal :> Vec3.t)
  | (Sphere _ | Plane _), _ -> false

let pp ppf = function
  | Sphere s ->
      Format.fprintf ppf "sphere centre %a radius %a" Vec3.pp (Sphere.centre s)
        Number.pp s.radius
  | Plane p ->
      Format.fprintf ppf "plane through %a normal %a" Vec3.pp p.point
        Direction.pp p.normal
