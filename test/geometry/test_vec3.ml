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
      Alcotest.test_case "measures" `Quick test_measures;
      Alcotest.test_case "overflow and underflow" `Quick test_limits;
      Alcotest.test_case "equality" `Quick test_equality;
      Alcotest.test_case "pp" `Quick test_pp;
    ] )
