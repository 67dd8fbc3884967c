type t = Sphere of Sphere.t | Plane of Plane.t

let sphere ~centre ~radius = Sphere (Sphere.make ~centre ~radius)

let plane ~point ~normal =
  Plane (Plane.make ~point ~normal:(Direction.of_vec3_exn normal))

(* {1 What is hit} *)

let intersections = function
  | Sphere s -> Sphere.intersections s
  | Plane p -> Plane.intersections p

let[@inline] nearest_raw shape ray =
  match shape with
  | Sphere { cx; cy; cz; radius } -> Sphere.nearest_raw cx cy cz radius ray
  | Plane { point = p; normal } ->
      let n = (normal :> Vec3.t) in
      Plane.nearest_raw p.x p.y p.z n.x n.y n.z ray

let nearest shape (ray : Ray.t) = nearest_raw shape (ray :> Raw_ray.t)

let[@inline] normal_raw shape x y z =
  match shape with
  | Sphere s -> Sphere.normal s (Vec3.make x y z)
  | Plane p -> p.normal

let normal shape { Vec3.x; y; z } = normal_raw shape x y z

let depth shape point =
  match shape with Sphere s -> Sphere.depth s point | Plane _ -> neg_infinity

let ball = function Sphere s -> Some s | Plane _ -> None

(* {1 What is told} *)

let name = function Sphere _ -> Sphere.name | Plane _ -> Plane.name
let parts = function Sphere s -> Sphere.parts s | Plane p -> Plane.parts p

let outline : t -> Outline.t = function
  | Sphere s -> Ball s
  | Plane p -> Endless p

let equal a b =
  let equal_part (_, a) (_, b) = Part.equal a b in
  name a = name b && List.equal equal_part (parts a) (parts b)

(* The first number is the kind. *)
let place = function
  | Sphere { cx; cy; cz; radius } -> [| 0.; cx; cy; cz; radius |]
  | Plane p -> Array.append [| 1. |] (Plane.place p)

let pp ppf = function Sphere s -> Sphere.pp ppf s | Plane p -> Plane.pp ppf p
