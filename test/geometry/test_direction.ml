open Raylab_geometry
open Test_support
open Build

let near_direction = Alcotest.(check (option (Same.direction_near 4e-16)))
let of_xyz x y z = Direction.of_vec3 (v x y z)

(* 2, 3, 6 has length 7. *)
let test_everyday () =
  near_direction "2 3 6"
    (Some (dir (2. /. 7.) (3. /. 7.) (6. /. 7.)))
    (of_xyz 2. 3. 6.);
  near_direction "-0.25 0 0" (Some (dir (-1.) 0. 0.)) (of_xyz (-0.25) 0. 0.)

(* 3 : 4 at any size gives 3/5, 4/5, though the squares leave the doubles. *)
let test_every_size () =
  let three_fifths = Some (dir 0.6 0.8 0.) in
  List.iter
    (fun k ->
      near_direction (Printf.sprintf "%g" k) three_fifths
        (of_xyz (3. *. k) (4. *. k) 0.))
    [ 1e-300; 1e-200; 1e-162; 1e-150; 1e-140; 1e140; 1e150; 1e200; 1e307 ];
  near_direction "mixed sizes" (Some (dir 1. 0. 0.)) (of_xyz 1e200 1e-200 1.)

(* The smallest double is 5e-324, and two of it are 1e-323: the vector (1, 2, 2)
   in units of it has length 3. *)
let test_smallest () =
  let s = 5e-324 in
  near_direction "one" (Some (dir 0. (-1.) 0.)) (of_xyz 0. (-.s) 0.);
  near_direction "1, 2, 2"
    (Some (dir (1. /. 3.) (2. /. 3.) (2. /. 3.)))
    (of_xyz s (2. *. s) (2. *. s))

(* Three components of max_float: each is 1 / sqrt 3. *)
let test_largest () =
  let third = 1. /. sqrt 3. in
  near_direction "all the largest"
    (Some (dir third third third))
    (of_xyz max_float max_float max_float)

let test_none () =
  let check = Alcotest.(check (option Same.direction)) in
  check "zero" None (of_xyz 0. 0. 0.);
  check "-0" None (of_xyz (-0.) 0. (-0.));
  List.iter
    (fun bad ->
      check "alone" None (of_xyz bad 0. 0.);
      check "among others" None (of_xyz 1. bad 2.);
      check "last" None (of_xyz 1e200 0. bad))
    [ nan; infinity; neg_infinity ];
  Expect.invalid "of_vec3_exn zero" (fun () -> Direction.of_vec3_exn Vec3.zero);
  Alcotest.check Same.direction "the default" (dir 0. 1. 0.)
    (Direction.of_vec3_or (dir 0. 1. 0.) Vec3.zero)

let test_neg () =
  Alcotest.check Same.direction "neg" (dir (-0.6) 0.8 0.)
    (Direction.neg (dir 0.6 (-0.8) 0.))

let exactly (a : Direction.t) (b : Direction.t) =
  Vec3.equal (a :> Vec3.t) (b :> Vec3.t)

let unit_length =
  Property.holds "length 1 from vectors of any size" ~count:2000
    ~print:(Property.show Vec3.pp) (Generate.vec3 Generate.extreme) (fun v ->
      match Direction.of_vec3 v with
      | None -> Vec3.equal v Vec3.zero
      | Some d -> abs_float (Vec3.length (d :> Vec3.t) -. 1.) < 1e-15)

let idempotent =
  Property.holds "of_vec3 changes no direction" ~count:2000
    ~print:(Property.show Direction.pp) (Generate.direction Generate.extreme)
    (fun d ->
      match Direction.of_vec3 (d :> Vec3.t) with
      | Some d' -> exactly d d'
      | None -> false)

let suite =
  ( "Direction",
    [
      Alcotest.test_case "everyday vectors" `Quick test_everyday;
      Alcotest.test_case "vectors of every size" `Quick test_every_size;
      Alcotest.test_case "the smallest doubles" `Quick test_smallest;
      Alcotest.test_case "the largest doubles" `Quick test_largest;
      Alcotest.test_case "vectors without direction" `Quick test_none;
      Alcotest.test_case "neg" `Quick test_neg;
      unit_length;
      idempotent;
    ] )
