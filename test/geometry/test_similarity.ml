open Raylab_geometry
open Test_support
open Build
open QCheck2

let near = Same.vec3_near 1e-12
let check what expected found = Alcotest.check near what expected found
let quarter axis = Similarity.rotated ~axis ~sin:1. ~cos:0.

(* With the left thumb along the axis, along the fingers: x goes to the right, y
   up and z away, so around y what is far goes to the right. *)
let test_rotated () =
  let y = quarter (dir 0. 1. 0.) in
  check "far to the right" (v 2. 0. 0.) (Similarity.point y (v 0. 0. 2.));
  check "right to the near" (v 0. 0. (-2.)) (Similarity.point y (v 2. 0. 0.));
  check "the axis stays" (v 0. 3. 0.) (Similarity.point y (v 0. 3. 0.));
  check "up to the far" (v 0. 0. 1.)
    (Similarity.direction (quarter (dir 1. 0. 0.)) (v 0. 1. 0.));
  check "right to up" (v 0. 1. 0.)
    (Similarity.direction (quarter (dir 0. 0. 1.)) (v 1. 0. 0.))

let test_parts () =
  let p = v 1. 2. 3. in
  check "identity" p (Similarity.point Similarity.identity p);
  check "scaled" (v 2. 4. 6.) (Similarity.point (Similarity.scaled 2.) p);
  check "translated" (v 2. 2. 2.)
    (Similarity.point (Similarity.translated (v 1. 0. (-1.))) p);
  check "directions are not moved" p
    (Similarity.direction (Similarity.translated (v 1. 0. (-1.))) p);
  check "nor scaled" p (Similarity.direction (Similarity.scaled 2.) p);
  Alcotest.(check (float 0.)) "factor" 2. Similarity.(factor (scaled 2.));
  Alcotest.(check (float 0.))
    "of a turn" 1.
    Similarity.(factor (quarter (dir 0. 1. 0.)))

let test_compose () =
  let move = Similarity.translated (v 1. 0. 0.)
  and turn = quarter (dir 0. 0. 1.)
  and grow = Similarity.scaled 3. in
  let origin = v 0. 0. 0. in
  check "moved, then turned" (v 0. 1. 0.)
    (Similarity.point (Similarity.compose turn move) origin);
  check "turned, then moved" (v 1. 0. 0.)
    (Similarity.point (Similarity.compose move turn) origin);
  check "moved, then larger" (v 3. 0. 0.)
    (Similarity.point (Similarity.compose grow move) origin)

let similarity =
  let open Gen in
  let rotated =
    let+ axis = Generate.direction Generate.everyday
    and+ angle = float_range 0. 6.3 in
    Similarity.rotated ~axis ~sin:(sin angle) ~cos:(cos angle)
  in
  let one =
    oneof
      [
        rotated;
        map Similarity.scaled (float_range 0.1 3.);
        map Similarity.translated (Generate.vec3 Generate.everyday);
      ]
  in
  map
    (List.fold_left Similarity.compose Similarity.identity)
    (list_size (int_range 1 5) one)

let close a b =
  Vec3.(length (sub a b)) <= 1e-9 *. (1. +. Vec3.length a +. Vec3.length b)

let composes =
  Property.holds "compose is one after the other"
    Gen.(triple similarity similarity (Generate.vec3 Generate.everyday))
    (fun (second, first, p) ->
      let both = Similarity.compose second first in
      close (Similarity.point both p)
        (Similarity.point second (Similarity.point first p))
      && close
           (Similarity.direction both p)
           (Similarity.direction second (Similarity.direction first p)))

let keeps_distances =
  Property.holds "all distances change by the factor"
    Gen.(
      triple similarity
        (Generate.vec3 Generate.everyday)
        (Generate.vec3 Generate.everyday))
    (fun (s, p, q) ->
      let distance a b = Vec3.(length (sub a b)) in
      let before = Similarity.factor s *. distance p q
      and after = distance (Similarity.point s p) (Similarity.point s q) in
      Float.abs (before -. after) <= 1e-7 *. (1. +. before))

let keeps_lengths =
  Property.holds "directions stay as long as they are"
    Gen.(pair similarity (Generate.vec3 Generate.everyday))
    (fun (s, d) ->
      let length = Vec3.length d in
      Float.abs (Vec3.length (Similarity.direction s d) -. length)
      <= 1e-9 *. (1. +. length))

let suite =
  ( "Similarity",
    [
      Alcotest.test_case "rotated" `Quick test_rotated;
      Alcotest.test_case "scaled and translated" `Quick test_parts;
      Alcotest.test_case "compose" `Quick test_compose;
      composes;
      keeps_distances;
      keeps_lengths;
    ] )
