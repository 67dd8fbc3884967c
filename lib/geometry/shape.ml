type t =
  | Sphere of Sphere.t
  | Plane of Plane.t
  | Box of Box.t
  | Cylinder of Cylinder.t
  | Cone of Cone.t
  | Torus of Torus.t
  | Disc of Disc.t
  | Triangle of Triangle.t
  | Quad of Quad.t
  | Mesh of Mesh.t
  | Placed of t Placed.t
  | Solid of t Solid.t

let sphere ~centre ~radius = Sphere (Sphere.make ~centre ~radius)

let plane ~point ~normal =
  Plane (Plane.make ~point ~normal:(Direction.of_vec3_exn normal))

let box_between ~corner ~opposite = Box (Box.make ~corner ~opposite)
let cylinder a b ~radius = Cylinder (Cylinder.make a b ~radius)
let cone a radius_a b radius_b = Cone (Cone.make a radius_a b radius_b)

let torus ~centre ~axis ~ring ~tube =
  Torus (Torus.make ~centre ~axis:(Direction.of_vec3_exn axis) ~ring ~tube)

let disc ~centre ~normal ~radius =
  Disc (Disc.make ~centre ~normal:(Direction.of_vec3_exn normal) ~radius)

let triangle a b c = Triangle (Triangle.make a b c)
let quad ~corner ~edge ~other = Quad (Quad.make ~corner ~edge ~other)

(* {1 Changes} *)

let by_similarity change = function
  | Sphere s ->
      Some
        (sphere
           ~centre:(Similarity.point change (Sphere.centre s))
           ~radius:(Similarity.factor change *. s.radius))
  | Plane p ->
      Some
        (plane
           ~point:(Similarity.point change p.point)
           ~normal:(Similarity.direction change (p.normal :> Vec3.t)))
  | Box { low; high } ->
      if Similarity.keeps_axes change then
        Some
          (box_between
             ~corner:(Similarity.point change low)
             ~opposite:(Similarity.point change high))
      else None
  | Cylinder c ->
      let { Frustum.a; b; radius_a; _ } = (c :> Frustum.t) in
      Some
        (cylinder
           (Similarity.point change a)
           (Similarity.point change b)
           ~radius:(Similarity.factor change *. radius_a))
  | Cone c ->
      let { Frustum.a; b; radius_a; radius_b; _ } = (c :> Frustum.t) in
      let factor = Similarity.factor change in
      Some
        (cone
           (Similarity.point change a)
           (factor *. radius_a)
           (Similarity.point change b)
           (factor *. radius_b))
  | Torus { centre; axis; ring; tube } ->
      let factor = Similarity.factor change in
      Some
        (torus
           ~centre:(Similarity.point change centre)
           ~axis:(Similarity.direction change (axis :> Vec3.t))
           ~ring:(factor *. ring) ~tube:(factor *. tube))
  | Disc { centre; normal; radius } ->
      Some
        (disc
           ~centre:(Similarity.point change centre)
           ~normal:(Similarity.direction change (normal :> Vec3.t))
           ~radius:(Similarity.factor change *. radius))
  | Triangle _ | Quad _ | Mesh _ | Placed _ | Solid _ -> None

(* What is mirrored keeps the side of its normal. *)
let by_affine change = function
  | Plane p -> Some (Plane (Placed.plane (Placed.make change p)))
  | Triangle { a; b; c; _ } ->
      let affine = Change.affine change in
      let point = Affine.point affine in
      Some
        (if Affine.determinant affine < 0. then
           triangle (point a) (point c) (point b)
         else triangle (point a) (point b) (point c))
  | Quad { corner; edge; other; _ } ->
      let affine = Change.affine change in
      let corner = Affine.point affine corner
      and edge = Affine.vector affine edge
      and other = Affine.vector affine other in
      Some
        (if Affine.determinant affine < 0. then
           quad ~corner ~edge:other ~other:edge
         else quad ~corner ~edge ~other)
  | Sphere _ | Box _ | Cylinder _ | Cone _ | Torus _ | Disc _ | Mesh _
  | Placed _ | Solid _ ->
      None

(* What stays of its kind. *)
let baked change shape =
  let similar =
    Option.bind (Change.similarity change) (fun similarity ->
        by_similarity similarity shape)
  in
  if Option.is_some similar then similar else by_affine change shape

let box_of_placed box (placed : t Placed.t) =
  match placed.own with
  | Sphere s -> Some (Sphere.box_through placed.out s)
  | own -> Option.map (fun own -> Placed.box own placed) (box own)

let rec box = function
  | Sphere s -> Some (Sphere.box s)
  | Plane _ -> None
  | Box b -> Some (Box.box b)
  | Cylinder c -> Some (Frustum.box (c :> Frustum.t))
  | Cone c -> Some (Frustum.box (c :> Frustum.t))
  | Torus t -> Some (Torus.box t)
  | Disc d -> Some (Disc.box d)
  | Triangle t -> Some (Box3.around (Triangle.corners t))
  | Quad q -> Some (Box3.around (Quad.corners q))
  | Mesh m -> Some (Mesh.box m)
  | Placed p -> box_of_placed box p
  | Solid s -> Solid.box box s

let placed p =
  let is_finite { Box3.low; high } =
    Vec3.is_finite low && Vec3.is_finite high
  in
  if not (Option.fold ~none:true ~some:is_finite (box (Placed p))) then
    invalid_arg "a shape that reaches beyond the range of numbers";
  Placed p

let rec transformed ?(keep_own = false) change shape =
  match (shape, if keep_own then None else baked change shape) with
  | _, Some shape -> shape
  | own, None when Change.modifiers change = [] -> own
  | Placed p, None -> placed (Placed.change change p)
  | Solid s, None -> Solid (Solid.map (transformed ~keep_own change) s)
  | own, None when Change.modifiers change = [] -> own
  | own, None -> placed (Placed.make change own)

(* {1 Solids} *)

let rec is_solid = function
  | Sphere _ | Plane _ | Box _ | Cylinder _ | Cone _ | Torus _ | Solid _ ->
      true
  | Disc _ | Triangle _ | Quad _ -> false
  | Mesh m -> Mesh.is_closed m
  | Placed p -> is_solid p.own

let rec opening = function
  | Mesh m -> Mesh.opening m
  | Placed p -> opening p.own
  | Sphere _ | Plane _ | Box _ | Cylinder _ | Cone _ | Torus _ | Disc _
  | Triangle _ | Quad _ | Solid _ ->
      None

(* A solid among the members is a part of the whole. *)
let rec spread : t Solid.tree -> t Solid.tree = function
  | Member (Solid s) -> Solid.to_tree s
  | Member _ as member -> member
  | Combined (operation, parts) -> Combined (operation, List.map spread parts)

let solid tree =
  let solid = Solid.make (spread tree) in
  match Array.find_opt (fun shape -> not (is_solid shape)) solid.members with
  | Some _ -> invalid_arg "a solid of a shape that has no inside"
  | None -> Solid solid

let with_members members = function
  | Solid s -> Solid (Solid.with_members members s)
  | shape -> shape

let with_tolerance tolerance = function
  | Solid s -> Solid (Solid.with_tolerance tolerance s)
  | shape -> shape

(* {1 What is hit} *)

let rec crossings_raw shape ray crossings =
  match shape with
  | Sphere s -> Sphere.crossings s ray crossings
  | Plane p -> Plane.crossings p ray crossings
  | Box b -> Box.crossings b ray crossings
  | Cylinder c -> Frustum.crossings (c :> Frustum.t) ray crossings
  | Cone c -> Frustum.crossings (c :> Frustum.t) ray crossings
  | Torus t -> Torus.crossings t ray crossings
  | Disc d -> Disc.crossings d ray crossings
  | Triangle t -> Triangle.crossings t ray crossings
  | Quad q -> Quad.crossings q ray crossings
  | Mesh m -> Mesh.crossings m ray crossings
  | Placed p -> Placed.crossings crossings_raw p ray crossings
  | Solid s -> Solid.crossings crossings_raw s ray crossings

let rec offer shape ray meeting ~number =
  match shape with
  | Sphere s -> Sphere.offer s ray meeting ~number
  | Plane p -> Plane.offer p ray meeting ~number
  | Box b -> Box.offer b ray meeting ~number
  | Cylinder c -> Frustum.offer (c :> Frustum.t) ray meeting ~number
  | Cone c -> Frustum.offer (c :> Frustum.t) ray meeting ~number
  | Torus t -> Torus.offer t ray meeting ~number
  | Disc d -> Disc.offer d ray meeting ~number
  | Triangle t -> Triangle.offer t ray meeting ~number
  | Quad q -> Quad.offer q ray meeting ~number
  | Mesh m -> Mesh.offer m ray meeting ~number
  | Placed p -> Placed.offer offer p ray meeting ~number
  | Solid s -> Solid.offer crossings_raw s ray meeting ~number

let rec settle shape ~part ray spot =
  match shape with
  | Sphere s -> Sphere.settle s ray spot
  | Plane p -> Plane.settle p ray spot
  | Box b -> Box.settle b ~part ray spot
  | Cylinder c -> Frustum.settle (c :> Frustum.t) ~part ray spot
  | Cone c -> Frustum.settle (c :> Frustum.t) ~part ray spot
  | Torus t -> Torus.settle t ray spot
  | Disc d -> Disc.settle d ray spot
  | Triangle t -> Triangle.settle t ray spot
  | Quad q -> Quad.settle q ray spot
  | Mesh m -> Mesh.settle m ~part ray spot
  | Placed p -> Placed.settle settle p ~part ray spot
  | Solid s -> Solid.settle settle s ~part ray spot

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

(* As part of a solid, a plane is a half-space. *)
let rec depth_in_solid shape point =
  match shape with
  | Sphere s -> Sphere.depth s point
  | Plane p -> Plane.depth p point
  | Box b -> Box.depth b point
  | Cylinder c -> Frustum.depth (c :> Frustum.t) point
  | Cone c -> Frustum.depth (c :> Frustum.t) point
  | Torus t -> Torus.depth t point
  | Mesh m -> Mesh.depth m point
  | Placed p -> Placed.depth depth_in_solid p point
  | Solid s -> Solid.depth depth_in_solid s point
  | Disc _ | Triangle _ | Quad _ -> neg_infinity

let rec depth shape point =
  match shape with
  | Plane _ -> neg_infinity
  | Placed p -> Placed.depth depth p point
  | Solid _ when Option.is_none (box shape) -> neg_infinity
  | _ -> depth_in_solid shape point

(* {1 What is told} *)

let rec name = function
  | Sphere _ -> Sphere.name
  | Plane _ -> Plane.name
  | Box _ -> Box.name
  | Cylinder _ -> Cylinder.name
  | Cone _ -> Cone.name
  | Torus _ -> Torus.name
  | Disc _ -> Disc.name
  | Triangle _ -> Triangle.name
  | Quad _ -> Quad.name
  | Mesh _ -> Mesh.name
  | Placed p -> name p.own
  | Solid s -> Solid.word (Solid.operation s)

let rec part shape k =
  match shape with
  | Box _ -> Some (Box.part k)
  | Cylinder _ | Cone _ -> Frustum.part k
  | Mesh m -> Some (Mesh.part m k)
  | Placed p -> part p.own k
  | Sphere _ | Plane _ | Torus _ | Disc _ | Triangle _ | Quad _ -> None
  | Solid s ->
      part s.members.(Solid.member_of s ~part:k) (Solid.own_part s ~part:k)

let rec parameters = function
  | Sphere s -> Sphere.parameters s
  | Plane p -> Plane.parameters p
  | Box b -> Box.parameters b
  | Cylinder c -> Cylinder.parameters c
  | Cone c -> Cone.parameters c
  | Torus t -> Torus.parameters t
  | Disc d -> Disc.parameters d
  | Triangle t -> Triangle.parameters t
  | Quad q -> Quad.parameters q
  | Mesh m -> Mesh.parameters m
  | Placed p -> parameters p.own
  | Solid _ -> []

let modifiers = function Placed p -> p.modifiers | _ -> []

let between_rims (frustum : Frustum.t) =
  List.concat_map (Round.rim frustum.axis) (Frustum.circles frustum)

let is_endless shape = Option.is_none (box shape)

(* What is taken away is not drawn, nor what only cuts. *)
let shown ({ members; flipped; _ } : t Solid.t) =
  let kept =
    List.filteri (fun m _ -> not flipped.(m)) (Array.to_list members)
  in
  match List.filter (fun shape -> not (is_endless shape)) kept with
  | [] -> kept
  | bounded -> bounded

let rec outline : t -> Outline.t = function
  | Sphere s -> Ball s
  | Plane p -> Endless p
  | Box b -> Body [ Box.corners b ]
  | Cylinder c -> Body [ between_rims (c :> Frustum.t) ]
  | Cone c -> Body [ between_rims (c :> Frustum.t) ]
  | Torus t -> Body (Torus.pieces t)
  | Disc { centre; normal; radius } ->
      Patch (Round.rim normal (centre, radius))
  | Triangle t -> Patch (Triangle.corners t)
  | Quad q -> Patch (Quad.corners q)
  | Mesh m -> Body [ Mesh.some_points m ]
  | Placed ({ own; out; _ } as placed) -> (
      let all = List.map (Affine.point out) in
      match outline own with
      | Ball s -> Body [ all (Sphere.rim s) ]
      | Body pieces -> Body (List.map all pieces)
      | Patch corners -> Patch (all corners)
      | Endless plane -> Endless (Placed.plane (Placed.with_own plane placed))
      | Several _ as several -> several)
  | Solid s -> Several (List.map outline (shown s))

let equal_parameter (_, a) (_, b) = Parameter.equal a b

let equal_modifier a b =
  Change.name a = Change.name b
  && List.equal equal_parameter (Change.parameters a) (Change.parameters b)

let rec equal_mesh a b =
  match (a, b) with
  | Mesh a, Mesh b -> Mesh.equal a b
  | Placed a, Placed b -> equal_mesh a.own b.own
  | _ -> true

let rec equal a b =
  match (a, b) with
  | Solid a, Solid b ->
      a.tree = b.tree
      && List.equal equal (Array.to_list a.members) (Array.to_list b.members)
  | _ ->
      name a = name b
      && List.equal equal_parameter (parameters a) (parameters b)
      && List.equal equal_modifier (modifiers a) (modifiers b)
      && equal_mesh a b

let of_frustum frustum =
  Array.append [| 3. |] (Round.place (Frustum.circles frustum))

(* The first number is the kind. *)
let rec place = function
  | Sphere { cx; cy; cz; radius } -> [| 0.; cx; cy; cz; radius |]
  | Plane p -> Array.append [| 1. |] (Plane.place p)
  | Box { low; high } -> [| 2.; low.x; low.y; low.z; high.x; high.y; high.z |]
  | Cylinder c -> of_frustum (c :> Frustum.t)
  | Cone c -> of_frustum (c :> Frustum.t)
  | Torus { centre = { x; y; z }; axis; ring; tube } ->
      Array.append [| 4.; x; y; z; ring; tube |] (Plane.heading axis)
  | Disc d -> Array.append [| 5. |] (Disc.place d)
  | Triangle t -> Array.append [| 6. |] (Flat.place (Triangle.corners t))
  | Quad q -> Array.append [| 7. |] (Flat.place (Quad.corners q))
  | Mesh m -> Array.append [| 8. |] (Mesh.place m)
  | Placed p -> Array.concat [ [| -1. |]; Affine.numbers p.out; place p.own ]
  | Solid s ->
      Array.concat
        ([| -2. |] :: Solid.numbers s
        :: List.map place (Array.to_list s.members))

let rec pp ppf = function
  | Sphere s -> Sphere.pp ppf s
  | Plane p -> Plane.pp ppf p
  | Box b -> Box.pp ppf b
  | Cylinder c -> Cylinder.pp ppf c
  | Cone c -> Cone.pp ppf c
  | Torus t -> Torus.pp ppf t
  | Disc d -> Disc.pp ppf d
  | Triangle t -> Triangle.pp ppf t
  | Quad q -> Quad.pp ppf q
  | Mesh m -> Mesh.pp ppf m
  | Placed p as placed ->
      Format.fprintf ppf "%a%a" pp p.own (Change.pp_with Number.pp)
        (modifiers placed)
  | Solid s -> Solid.pp_with pp ppf s
