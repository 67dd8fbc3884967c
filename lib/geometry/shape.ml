type t = Sphere of Sphere.t | Plane of Plane.t | Placed of t Placed.t

let sphere ~centre ~radius = Sphere (Sphere.make ~centre ~radius)

let plane ~point ~normal =
  Plane (Plane.make ~point ~normal:(Direction.of_vec3_exn normal))

(* What stays of its kind. *)
let baked change shape =
  match (shape, Change.similarity change) with
  | Sphere s, Some similarity ->
      Some
        (sphere
           ~centre:(Similarity.point similarity (Sphere.centre s))
           ~radius:(Similarity.factor similarity *. s.radius))
  | Plane p, Some similarity ->
      Some
        (plane
           ~point:(Similarity.point similarity p.point)
           ~normal:(Similarity.direction similarity (p.normal :> Vec3.t)))
  | Plane p, None -> Some (Plane (Placed.plane (Placed.make change p)))
  | Sphere _, None | Placed _, _ -> None

let box_of_placed box (placed : t Placed.t) =
  match placed.own with
  | Sphere s -> Some (Sphere.box_through placed.out s)
  | own -> Option.map (fun own -> Placed.box own placed) (box own)

let rec box = function
  | Sphere s -> Some (Sphere.box s)
  | Plane _ -> None
  | Placed p -> box_of_placed box p

let placed p =
  let is_finite { Box3.low; high } =
    Vec3.is_finite low && Vec3.is_finite high
  in
  if not (Option.fold ~none:true ~some:is_finite (box (Placed p))) then
    invalid_arg "a shape that reaches beyond the range of numbers";
  Placed p

let transformed ?(keep_own = false) change shape =
  match (shape, if keep_own then None else baked change shape) with
  | _, Some shape -> shape
  | Placed p, None -> placed (Placed.change change p)
  | own, None -> placed (Placed.make change own)

(* {1 What is hit} *)

let rec offer shape ray meeting ~number =
  match shape with
  | Sphere s -> Sphere.offer s ray meeting ~number
  | Plane p -> Plane.offer p ray meeting ~number
  | Placed p -> Placed.offer offer p ray meeting ~number

let rec crossings_raw shape ray crossings =
  match shape with
  | Sphere s -> Sphere.crossings s ray crossings
  | Plane p -> Plane.crossings p ray crossings
  | Placed p -> Placed.crossings crossings_raw p ray crossings

let rec settle shape ~part ray spot =
  match shape with
  | Sphere s -> Sphere.settle s ray spot
  | Plane p -> Plane.settle p ray spot
  | Placed p -> Placed.settle settle p ~part ray spot

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

let rec depth shape point =
  match shape with
  | Sphere s -> Sphere.depth s point
  | Plane _ -> neg_infinity
  | Placed p -> Placed.depth depth p point

(* {1 What is told} *)

let rec name = function
  | Sphere _ -> Sphere.name
  | Plane _ -> Plane.name
  | Placed p -> name p.own

let rec parameters = function
  | Sphere s -> Sphere.parameters s
  | Plane p -> Plane.parameters p
  | Placed p -> parameters p.own

let modifiers = function Placed p -> p.modifiers | Sphere _ | Plane _ -> []

let rec outline : t -> Outline.t = function
  | Sphere s -> Ball s
  | Plane p -> Endless p
  | Placed ({ own; out; _ } as placed) -> (
      let all = List.map (Affine.point out) in
      match outline own with
      | Ball s -> Hull (all (Sphere.rim s))
      | Hull points -> Hull (all points)
      | Patch corners -> Patch (all corners)
      | Endless plane -> Endless (Placed.plane (Placed.with_own plane placed)))

let equal_parameter (_, a) (_, b) = Parameter.equal a b

let equal_modifier a b =
  Change.name a = Change.name b
  && List.equal equal_parameter (Change.parameters a) (Change.parameters b)

let equal a b =
  name a = name b
  && List.equal equal_parameter (parameters a) (parameters b)
  && List.equal equal_modifier (modifiers a) (modifiers b)

(* The first number is the kind. *)
let rec place = function
  | Sphere { cx; cy; cz; radius } -> [| 0.; cx; cy; cz; radius |]
  | Plane p -> Array.append [| 1. |] (Plane.place p)
  | Placed p -> Array.concat [ [| -1. |]; Affine.numbers p.out; place p.own ]

let rec pp ppf = function
  | Sphere s -> Sphere.pp ppf s
  | Plane p -> Plane.pp ppf p
  | Placed p as placed ->
      Format.fprintf ppf "%a%a" pp p.own (Change.pp_with Number.pp)
        (modifiers placed)
