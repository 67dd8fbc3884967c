open Raylab_geometry
open Raylab_expression

(* The numbers of try [k]; each is at least 0 and less than 1. *)
let random k n = Hash.random (float_of_int ((16 * k) + n))
let around_0 k n = (2. *. random k n) -. 1.

let direction k n =
  let v = Vec3.make (around_0 k n) (around_0 k (n + 1)) (around_0 k (n + 2)) in
  Option.value (Direction.of_vec3 v)
    ~default:(Direction.of_vec3_exn (Vec3.make 0. 1. 0.))

(* From outside through a point of the box. *)
let ray_through { Box3.low; high } k =
  let part n low high = low +. (random k n *. (high -. low)) in
  let target =
    Vec3.make (part 0 low.x high.x) (part 1 low.y high.y) (part 2 low.z high.z)
  and direction = direction k 3
  and size = Vec3.length (Vec3.sub high low) in
  let back = Vec3.scale (-2. *. size) (direction :> Vec3.t) in
  Ray.make ~origin:(Vec3.add target back) ~direction

(* Down on a plane, from a millionth to a million beside its point. *)
let ray_onto { Plane.point; normal } k =
  let distance = Power.pow 10. (6. *. around_0 k 0) in
  let beside = Vec3.scale distance (direction k 1 :> Vec3.t) in
  let n = (normal :> Vec3.t) in
  let beside = Vec3.sub beside (Vec3.scale (Vec3.dot beside n) n) in
  Ray.make
    ~origin:(Vec3.add (Vec3.add point beside) n)
    ~direction:(Direction.neg normal)

let own_point shape ray =
  match Shape.nearest shape ray with
  | None -> None
  | Some (t, part) ->
      let spot = Spot.create () and raw = Ray.to_raw ray in
      raw.reach <- t;
      Shape.settle shape ~part raw spot;
      let own = Spot.own spot in
      if Vec3.is_finite own then Some own else None

let rec of_shape count (shape : Shape.t) =
  let tries make =
    let own_point k =
      try own_point shape (make k) with Invalid_argument _ -> None
    in
    Seq.ints 0
    |> Seq.take (4 * count)
    |> Seq.filter_map own_point |> Seq.take count
  in
  match shape with
  | Plane plane -> tries (ray_onto plane)
  | Placed { own; _ } -> of_shape count own
  | shape -> (
      match Shape.box shape with
      | Some box -> tries (ray_through box)
      | None -> Seq.empty)

let directions count =
  Seq.map (fun k -> (direction k 0 :> Vec3.t)) (Seq.take count (Seq.ints 0))
