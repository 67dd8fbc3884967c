open Raylab_mesh_file

let cut corners =
  let corners = Array.of_list corners and found = ref [] in
  let points k axis = corners.(k).(axis) in
  let triangle a b c = found := (a, b, c) :: !found in
  let is_cut = Polygon.cut ~points ~count:(Array.length corners) triangle in
  (is_cut, List.rev !found)

let check what expected corners =
  Alcotest.(check (list (triple int int int)))
    what expected
    (snd (cut corners))

let test_convex () =
  check "a square, as a fan"
    [ (0, 1, 2); (0, 2, 3) ]
    [ [| 0.; 0.; 5. |]; [| 1.; 0.; 5. |]; [| 1.; 1.; 5. |]; [| 0.; 1.; 5. |] ]

(* An arrow head with its notch at (1, 0): a fan from the corner beside the notch
   would cover what is not in it. *)
let test_concave () =
  check "an arrow head"
    [ (0, 1, 2); (3, 0, 2) ]
    [ [| 0.; 0.; 0. |]; [| 4.; 3.; 0. |]; [| 1.; 0.; 0. |]; [| 4.; -3.; 0. |] ];
  check "the same from its point on"
    [ (1, 2, 3); (0, 1, 3) ]
    [ [| 4.; 3.; 0. |]; [| 1.; 0.; 0. |]; [| 4.; -3.; 0. |]; [| 0.; 0.; 0. |] ]

let area corners =
  let turn a b c =
    let at k axis = (List.nth corners k).(axis) in
    ((at b 0 -. at a 0) *. (at c 1 -. at a 1))
    -. ((at b 1 -. at a 1) *. (at c 0 -. at a 0))
  in
  turn

(* Stars with random spikes: they do not cross themselves, and they are wound
   in one sense. *)
let star =
  QCheck2.Gen.(
    let* count = int_range 4 40 in
    let* reaches = list_repeat count (float_range 0.1 1.) in
    return
      (List.mapi
         (fun k reach ->
           let angle =
             2. *. Float.pi *. float_of_int k /. float_of_int count
           in
           [| reach *. cos angle; reach *. sin angle; 0. |])
         reaches))

(* No triangle is turned over, and together they have the area of all: so they
   cover the star, once. *)
let stars_are_covered =
  Test_support.Property.holds "triangles cover a star" ~count:1000 star
    (fun corners ->
      let _, triangles = cut corners in
      let turn = area corners in
      let areas = List.map (fun (a, b, c) -> turn a b c) triangles in
      let count = List.length corners in
      let whole =
        List.init count (fun k ->
            let a = List.nth corners k
            and b = List.nth corners ((k + 1) mod count) in
            (a.(0) *. b.(1)) -. (a.(1) *. b.(0)))
      in
      let sum = List.fold_left ( +. ) 0. in
      List.length triangles = count - 2
      && List.for_all (fun a -> a >= -1e-15) areas
      && abs_float (sum areas -. sum whole) < 1e-9)

(* Whatever the points are, a polygon of n corners is n - 2 triangles. *)
let any_polygon_is_cut =
  Test_support.Property.holds "any polygon is cut" ~count:1000
    QCheck2.Gen.(
      list_size (int_range 3 30)
        (array_repeat 3 (oneof [ float; float_range (-2.) 2. ])))
    (fun corners ->
      let is_cut, triangles = cut corners in
      is_cut && List.length triangles = List.length corners - 2)

let test_too_many () =
  let saw count =
    List.init count (fun k ->
        [| float_of_int k; float_of_int (k land 1); 0. |])
  in
  Alcotest.(check bool)
    "5,002 corners" false
    (fst (cut (saw 5_001 @ [ [| 0.; -9.; 0. |] ])))

let suite =
  ( "Polygon",
    [
      Alcotest.test_case "convex" `Quick test_convex;
      Alcotest.test_case "concave" `Quick test_concave;
      Alcotest.test_case "too many corners" `Quick test_too_many;
      stars_are_covered;
      any_polygon_is_cut;
    ] )
