open Raylab_geometry
open Test_support
open Build

(* Ball number k is around (k, 2 k, 3 k). *)
let ball k =
  let x = float_of_int k in
  Shape.sphere ~centre:(v x (2. *. x) (3. *. x)) ~radius:0.5

let floor = Shape.plane ~point:Vec3.zero ~normal:(v 0. 1. 0.)

(* Shapes 0, 2, 3 and 5 have a box. *)
let shapes = [| ball 0; floor; ball 2; ball 3; floor; ball 5 |]
let places leaves = List.init (Bvh_leaves.count leaves) Fun.id

(* Whatever the order, everything that is told of a place is of its shape. *)
let check_places what all leaves =
  let numbers = Bvh_leaves.numbers leaves in
  let spheres = Shape_leaves.spheres all numbers in
  List.iter
    (fun place ->
      let x = float_of_int numbers.(place) in
      let y = 2. *. x and z = 3. *. x in
      let check_numbers part expected found =
        Alcotest.(check (list Same.number)) (what ^ part) expected found
      in
      check_numbers ", box"
        [ x -. 0.5; x +. 0.5; y -. 0.5; y +. 0.5; z -. 0.5; z +. 0.5 ]
        (List.init 6 (Bvh_leaves.side leaves place));
      check_numbers ", centre" [ x; y; z ]
        (List.init 3 (Bvh_leaves.centre leaves place));
      check_numbers ", row" [ x; y; z; 0.5 ]
        (Array.to_list (Array.sub spheres (4 * place) 4));
      Alcotest.(check bool)
        (what ^ ", kind") true
        (Bvh_leaves.kind leaves place = Sphere))
    (places leaves)

let test_of_shapes () =
  let leaves = Shape_leaves.of_shapes shapes in
  Alcotest.(check (list int))
    "those that have a box" [ 0; 2; 3; 5 ]
    (Array.to_list (Bvh_leaves.numbers leaves));
  check_places "as they come" shapes leaves;
  Alcotest.(check int)
    "none" 0
    (Bvh_leaves.count (Shape_leaves.of_shapes [| floor; floor |]));
  Alcotest.(check int)
    "no rows" 0
    (Array.length (Shape_leaves.spheres [| floor |] [||]))

(* Of places 1 to 3 those with numbers 3 and 5 come first; place 0 stays. *)
let test_partition () =
  let leaves = Shape_leaves.of_shapes shapes in
  let number place = (Bvh_leaves.numbers leaves).(place) in
  let middle =
    Bvh_leaves.partition leaves (fun place -> number place >= 3) 1 4
  in
  Alcotest.(check int) "two of them" 3 middle;
  Alcotest.(check int) "outside of it" 0 (number 0);
  Alcotest.(check (list int))
    "in front" [ 3; 5 ]
    (List.sort compare [ number 1; number 2 ]);
  Alcotest.(check int) "behind" 2 (number 3);
  check_places "parted" shapes leaves;
  let same what expected goes_first =
    Alcotest.(check int)
      what expected
      (Bvh_leaves.partition leaves goes_first 0 4)
  in
  same "all" 4 (fun _ -> true);
  same "none" 0 (fun _ -> false)

let any_partition =
  Property.holds "parts, and loses none"
    QCheck2.Gen.(list_size (0 -- 40) bool)
    (fun wanted ->
      let wanted = Array.of_list wanted in
      let count = Array.length wanted in
      let leaves = Shape_leaves.of_shapes (Array.init count ball) in
      let numbers = Bvh_leaves.numbers leaves in
      let is_wanted place = wanted.(numbers.(place)) in
      let middle = Bvh_leaves.partition leaves is_wanted 0 count in
      List.for_all
        (fun place -> is_wanted place = (place < middle))
        (places leaves)
      && List.sort compare (Array.to_list numbers) = List.init count Fun.id)

let test_one_kind () =
  let leaves = Shape_leaves.of_shapes shapes in
  Alcotest.(check bool) "spheres" true (Bvh_leaves.one_kind leaves 0 4);
  Alcotest.(check bool) "one sphere" true (Bvh_leaves.one_kind leaves 2 3)

let suite =
  ( "Bvh_leaves",
    [
      Alcotest.test_case "of shapes" `Quick test_of_shapes;
      Alcotest.test_case "partition" `Quick test_partition;
      Alcotest.test_case "one kind" `Quick test_one_kind;
      any_partition;
    ] )
