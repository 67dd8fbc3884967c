type t = Sphere of Sphere.t | Plane of Plane.t

let sphere ~centre ~radius = Sphere (Sphere.make ~centre ~radius)

let plane ~point ~normal =
  Plane (Plane.make ~point ~normal:(Direction.of_vec3_exn normal))

let transformed change = function
  | Sphere s ->
      sphere
        ~centre:(Similarity.point change (Sphere.centre s))
        ~radius:(Similarity.factor change *. s.radius)
  | Plane p ->
      plane
        ~point:(Similarity.point change p.point)
        ~normal:(Similarity.direction change (p.normal :> Vec3.t))

(* {1 What is hit} *)

let box = function Sphere s -> Some (Sphere.box s) | Plane _ -> None

let offer shape ray meeting ~number =
  match shape with
  | Sphere s -> Sphere.offer s ray meeting ~number
  | Plane p -> Plane.offer p ray meeting ~number

let crossings_raw shape ray crossings =
  match shape with
  | Sphere s -> Sphere.crossings s ray crossings
  | Plane p -> Plane.crossings p ray crossings

let settle shape ~part:_ ray spot =
  match shape with
  | Sphere s -> Sphere.settle s ray spot
  | Plane p -> Plane.settle p ray spot

(* {1 The same of values} *)

let nearest shape ray =
  let raw = Ray.to_raw ray and meeting = Meeting.create () in
  raw.reach <- infinity;
  offer shape raw meeting ~number:0;
  if Meeting.is_none meeting then None else Some (raw.reach, meeting.part)

let crossings shape ray =
  let crossings = Crossings.create () in
  crossings_raw shape (Ray.to_raw ray) crossings;
  Crossings.to_list crossings

let intersections shape ray =
  List.map (fun (c : Crossings.crossing) -> c.t) (crossings shape ray)

(* The point is the end of a ray that has just begun there. *)
let normal shape ?(part = 0) { Vec3.x; y; z } =
  let ray = Raw_ray.create () and spot = Spot.create () in
  Raw_ray.set_origin ray x y z;
  ray.reach <- 0.;
  settle shape ~part ray spot;
  Spot.normal spot

let depth shape point =
  match shape with Sphere s -> Sphere.depth s point | Plane _ -> neg_infinity

(* {1 What is told} *)

let name = function Sphere _ -> Sphere.name | Plane _ -> Plane.name

let parameters = function
  | Sphere s -> Sphere.parameters s
  | Plane p -> Plane.parameters p

let outline : t -> Outline.t = function
  | Sphere s -> Ball s
  | Plane p -> Endless p

let equal a b =
  let equal_parameter (_, a) (_, b) = Parameter.equal a b in
  name a = name b && List.equal equal_parameter (parameters a) (parameters b)

(* The first number is the kind. *)
let place = function
  | Sphere { cx; cy; cz; radius } -> [| 0.; cx; cy; cz; radius |]
  | Plane p -> Array.append [| 1. |] (Plane.place p)

let pp ppf = function Sphere s -> Sphere.pp ppf s | Plane p -> Plane.pp ppf p
