open Raylab_geometry
open Test_support
open Build

let check = Alcotest.check Same.vec3
let check_number = Alcotest.check Same.number
let a = v 1. 2. 3.
let b = v 4. (-5.) 6.

let test_arithmetic () =
  check "a + b" (v 5. (-3.) 9.) (Vec3.add a b);
  check "a - b" (v (-3.) 7. (-3.)) (Vec3.sub a b);
  check "2 a" (v 2. 4. 6.) (Vec3.scale 2. a);
  check "-b" (v (-4.) 5. (-6.)) (Vec3.neg b);
  check "a + 0" a (Vec3.add a Vec3.zero)

(* 1 * 4 + 2 * -5 + 3 * 6 = 12; 2, 3, 6 have the squares 4 + 9 + 36 = 49. *)
let test_measures () =
  check_number "a . b" 12. (Vec3.dot a b);
  check_number "|v|^2" 49. (Vec3.length_squared (v 2. (-3.) 6.));
  check_number "|v|" 7. (Vec3.length (v 2. (-3.) 6.));
  check_number "sum of absolutes" 11. (Vec3.magnitude (v 2. (-3.) 6.));
  check_number "|0|" 0. (Vec3.length Vec3.zero)

(* x, y and z follow each other round; (2, 0, 0) and (1, 3, 0) span a
   parallelogram of 2 * 3. *)
let test_cross () =
  let x = v 1. 0. 0. and y = v 0. 1. 0. and z = v 0. 0. 1. in
  check "x, y" z (Vec3.cross x y);
  check "y, z" x (Vec3.cross y z);
  check "z, x" y (Vec3.cross z x);
  check "the other way round" (v 0. 0. (-1.)) (Vec3.cross y x);
  check "area" (v 0. 0. 6.) (Vec3.cross (v 2. 0. 0.) (v 1. 3. 0.));
  check "of itself" Vec3.zero (Vec3.cross a a);
  check_number "perpendicular to a" 0. (Vec3.dot a (Vec3.cross a b));
  check_number "perpendicular to b" 0. (Vec3.dot b (Vec3.cross a b))

(* 2 (1, 2, 3) - (4, -5, 6) + (-(4, -5, 6)) *)
let test_infix () =
  check "all of them" (v (-6.) 14. (-6.)) Vec3.Infix.((2. * a) - b + -b)

let test_limits () =
  check_number "1e200 overflows" infinity (Vec3.length (v 1e200 0. 0.));
  check_number "1e-200 underflows" 0. (Vec3.length (v 0. 1e-200 0.));
  check_number "magnitude does not" 1e200 (Vec3.magnitude (v 1e200 0. 0.));
  check_number "NaN passes through" nan (Vec3.dot a (v nan 0. 0.))

let test_equality () =
  let holds = Alcotest.(check bool) in
  holds "0 and -0" true (Vec3.equal Vec3.zero (v (-0.) 0. (-0.)));
  holds "z counts" false (Vec3.equal a (v 1. 2. 4.));
  holds "NaN equals nothing" false (Vec3.equal (v nan 0. 0.) (v nan 0. 0.));
  holds "finite" true (Vec3.is_finite (v max_float (-0.) 5e-324));
  List.iter
    (fun bad ->
      holds "x" false (Vec3.is_finite (v bad 0. 0.));
      holds "y" false (Vec3.is_finite (v 0. bad 0.));
      holds "z" false (Vec3.is_finite (v 0. 0. bad)))
    [ nan; infinity; neg_infinity ]

let test_pp () =
  Expect.prints "as mathematics" "(1, 2.5, -3)" Vec3.pp (v 1. 2.5 (-3.));
  Expect.prints "no -0" "(0, 0, 0)" Vec3.pp (v (-0.) 0. 0.)

let suite =
  ( "Vec3",
    [
      Alcotest.test_case "arithmetic" `Quick test_arithmetic;
      Alcotest.test_case "cross" `Quick test_cross;
      Alcotest.test_case "operators" `Quick test_infix;
      Alcotest.test_case "measures" `Quick test_measures;
      Alcotest.test_case "overflow and underflow" `Quick test_limits;
      Alcotest.test_case "equality" `Quick test_equality;
      Alcotest.test_case "pp" `Quick test_pp;
    ] )
