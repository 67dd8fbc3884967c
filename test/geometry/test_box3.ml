open Raylab_geometry
open Test_support
open Build

let box = Box3.make ~low:(v (-1.) 0. 3.) ~high:(v 1. 6. 7.)

let test_values () =
  Alcotest.check Same.vec3 "centre" (v 0. 3. 5.) (Box3.centre box);
  Alcotest.check Same.number "half of 6" 3. (Box3.reach box);
  Expect.prints "pp" "(-1, 0, 3) to (1, 6, 7)" Box3.pp box

let test_flat () =
  let point = v 1. 2. 3. in
  let flat = Box3.make ~low:point ~high:point in
  Alcotest.check Same.vec3 "centre" point (Box3.centre flat);
  Alcotest.check Same.number "no length" 0. (Box3.reach flat)

(* Neither sum nor difference of the corners is a double. *)
let test_large () =
  let m = max_float in
  let both = Box3.make ~low:(v (-.m) m 0.) ~high:(v m m 0.) in
  Alcotest.check Same.vec3 "centre" (v 0. m 0.) (Box3.centre both);
  Alcotest.check Same.number "half the length" m (Box3.reach both)

let test_equal () =
  let differs what low high =
    Alcotest.(check bool) what false (Box3.equal box (Box3.make ~low ~high))
  in
  Alcotest.(check bool)
    "the same again" true
    (Box3.equal box (Box3.make ~low:box.low ~high:box.high));
  differs "low" (v (-1.) 0. 2.) box.high;
  differs "high" box.low (v 1. 6. 8.)

let test_invalid () =
  let refuse what low high =
    Expect.invalid what (fun () -> Box3.make ~low ~high)
  in
  refuse "x" (v 2. 0. 3.) box.high;
  refuse "y" (v 0. 6.1 3.) box.high;
  refuse "z" (v 0. 0. 8.) box.high;
  refuse "low NaN" (v nan 0. 3.) box.high;
  refuse "high NaN" box.low (v 1. 6. nan)

let suite =
  ( "Box3",
    [
      Alcotest.test_case "values" `Quick test_values;
      Alcotest.test_case "flat" `Quick test_flat;
      Alcotest.test_case "large" `Quick test_large;
      Alcotest.test_case "equal" `Quick test_equal;
      Alcotest.test_case "invalid" `Quick test_invalid;
    ] )
