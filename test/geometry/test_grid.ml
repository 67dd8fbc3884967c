(* A grid must answer as the plainest index does, shape for shape. *)

open Raylab_geometry
open Test_support

let leaves_of shapes =
  let bvh = Bvh.make shapes in
  Leaves.make shapes ~numbers:(Bvh.numbers bvh) ~balls:(Bvh.spheres bvh)

let answer ~any ask ray =
  let asked = Ray.to_raw ray and meeting = Meeting.create () in
  ask asked meeting;
  if Meeting.is_none meeting then None
  else if any then Some (0, 0, 0.)
  else Some (meeting.number, meeting.part, asked.reach)

let offer_all shapes ray meeting =
  Array.iteri (fun number s -> Shape.offer s ray meeting ~number) shapes

(* Of what has no box a grid knows nothing. *)
let agrees (shapes, rays) =
  let has_box shape = Option.is_some (Shape.box shape) in
  let shapes = Array.of_seq (Seq.filter has_box (Array.to_seq shapes)) in
  let leaves = leaves_of shapes in
  match Grid.make leaves with
  | None -> true
  | Some grid ->
      let agrees ray =
        (not (Grid.has_ray_from grid (Ray.to_raw ray)))
        || answer ~any:false (Grid.nearest grid leaves) ray
           = answer ~any:false (offer_all shapes) ray
           && answer ~any:true (Grid.some grid leaves) ray
              = answer ~any:true (offer_all shapes) ray
      in
      List.for_all agrees rays

let shapes_and_rays sizes number =
  QCheck2.Gen.(
    pair
      (array_size sizes (Generate.shape number))
      (list_size (1 -- 30) (Generate.ray number)))

(* Corners, faces and rays on the sides of cells. *)
let on_a_grid =
  QCheck2.Gen.(
    let cell = map float_of_int (-3 -- 3) in
    let box_or_ball is_box centre radius =
      if is_box then
        let far = Vec3.make radius radius radius in
        Shape.box_between ~corner:centre ~opposite:(Vec3.add centre far)
      else Shape.sphere ~centre ~radius
    in
    pair
      (array_size (1 -- 60)
         (map3 box_or_ball bool (Generate.vec3 cell) (oneofl [ 0.5; 1.; 2. ])))
      (list_size (1 -- 30) (Generate.ray cell)))

let print (shapes, rays) =
  Format.asprintf "%a@.%a"
    (Format.pp_print_list Shape.pp)
    (Array.to_list shapes)
    (Format.pp_print_list Ray.pp)
    rays

let holds name count gen = Property.holds name ~count ~print gen agrees

(* {1 What it has trouble with} *)

let sphere x y z radius = Shape.sphere ~centre:(Vec3.make x y z) ~radius

let some_rays =
  QCheck2.Gen.generate ~n:300
    ~rand:(Random.State.make [| 5 |])
    (Generate.ray Generate.everyday)

let check_same name shapes =
  Alcotest.(check bool)
    (name ^ ", made") true
    (Option.is_some (Grid.make (leaves_of shapes)));
  Alcotest.(check bool) name true (agrees (shapes, some_rays))

let test_degenerate () =
  Alcotest.(check bool) "nothing" true (Grid.make (leaves_of [||]) = None);
  check_same "one sphere" [| sphere 0. 0. 3. 1. |];
  check_same "all alike" (Array.make 2000 (sphere 0. 0. 3. 1.));
  let small k x =
    sphere x
      (float_of_int (k mod 50) /. 10.)
      (float_of_int (k / 50) /. 10.)
      0.04
  in
  check_same "one around all"
    (Array.init 2501 (fun k ->
         if k = 0 then sphere 0. 0. 0. 1e6 else small k 4.));
  check_same "two crowds far apart"
    (Array.init 4000 (fun k ->
         let { Vec3.x; y; z } =
           Vec3.scale (if k land 1 = 0 then 1. else -1.) (Vec3.make 3. 3. 3.)
         in
         let at n = float_of_int (k / n mod 10) *. 0.01 in
         sphere (x +. at 2) (y +. at 20) (z +. at 200) 0.004));
  let flat k =
    let x = float_of_int (k mod 20) and y = float_of_int (k / 20) in
    Shape.quad ~corner:(Vec3.make x y 0.) ~edge:(Vec3.make 1. 0. 0.)
      ~other:(Vec3.make 0. 1. 0.)
  in
  check_same "in a plane" (Array.init 400 flat)

(* A sphere around all is in every cell. *)
let test_too_many () =
  let around k = sphere 0. 0. 0. (10. +. float_of_int k) in
  Alcotest.(check bool)
    "in one cell" true
    (Option.is_some (Grid.make (leaves_of (Array.init 2000 around))))

(* A line that crosses a cube of n x n x n cells crosses n^3 * 6 / (6 n^2) = n
   of them; here 8 spheres in the corners of a cube of 2 x 2 x 2, which is a step
   of 0.3 for each of two cells, and 0.2 for one sphere in each. *)
let test_cost () =
  let ball k =
    let at n = if k land n = 0 then 0. else 1. in
    sphere (at 1) (at 2) (at 4) 0.4
  in
  match Grid.make (leaves_of (Array.init 8 ball)) with
  | None -> Alcotest.fail "no grid"
  | Some grid ->
      Alcotest.check (Same.near 1e-6) "cost"
        ((2. *. 0.3) +. (2. *. 0.2))
        (Grid.cost grid)

let suite =
  ( "Grid",
    [
      Alcotest.test_case "degenerate" `Quick test_degenerate;
      Alcotest.test_case "too many" `Quick test_too_many;
      Alcotest.test_case "cost" `Quick test_cost;
      holds "as brute force" 500
        (shapes_and_rays QCheck2.Gen.(1 -- 80) Generate.everyday);
      holds "of many" 20
        (shapes_and_rays (QCheck2.Gen.pure 2000) Generate.everyday);
      holds "on a grid" 500 on_a_grid;
      holds "with numbers of any size" 1000
        (shapes_and_rays QCheck2.Gen.(1 -- 40) Generate.extreme);
    ] )
