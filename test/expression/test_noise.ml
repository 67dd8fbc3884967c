open Raylab_expression
open Test_support

let check = Alcotest.check Same.number
let state () = Random.State.make [| 3 |]

let for_points count f =
  let state = state () in
  let coordinate () = Random.State.float state 2000. -. 1000. in
  for _ = 1 to count do
    f (coordinate ()) (coordinate ()) (coordinate ())
  done

(* Perlin's sum with the worst of directions at each corner of a cell: an edge's
   direction gives two of three coordinates. Nowhere is it more than what the
   noise is divided by, and somewhere it is almost that. *)
let test_scale () =
  let fade t = t *. t *. t *. ((t *. ((t *. 6.) -. 15.)) +. 10.) in
  let worst x y z =
    let sum = ref 0. in
    let corner i j k =
      let weight at t = if at = 0. then 1. -. fade t else fade t in
      let a = abs_float (x -. i)
      and b = abs_float (y -. j)
      and c = abs_float (z -. k) in
      let largest = a +. b +. c -. Float.min a (Float.min b c) in
      sum := !sum +. (weight i x *. weight j y *. weight k z *. largest)
    in
    let ends = [ 0.; 1. ] in
    List.iter
      (fun i -> List.iter (fun j -> List.iter (corner i j) ends) ends)
      ends;
    !sum
  in
  let most = ref 0. in
  for i = 0 to 100 do
    for j = 0 to 100 do
      let at n = float n /. 100. in
      for k = 0 to 50 do
        most := Float.max !most (worst (at i) (at j) (at k))
      done
    done
  done;
  Alcotest.(check bool) "at most" true (!most <= 1.036353812);
  Alcotest.(check bool) "almost" true (!most >= 1.0363)

let test_range () =
  let sum = ref 0. and squares = ref 0. and most = ref 0. in
  let count = 500_000 in
  for_points count (fun x y z ->
      let n = Noise.noise x y z in
      sum := !sum +. n;
      squares := !squares +. (n *. n);
      most := Float.max !most (abs_float n));
  let mean x = x /. float count in
  Alcotest.(check (float 0.002)) "mean" 0. (mean !sum);
  Alcotest.(check (float 0.005)) "deviation" 0.261 (sqrt (mean !squares));
  Alcotest.(check bool) "within 1" true (!most <= 1.);
  Alcotest.(check bool) "and far" true (!most > 0.9)

(* A 256th of a wave changes it by little, across cells too. *)
let test_smooth () =
  let step = 1. /. 256. in
  for_points 100_000 (fun x y z ->
      let n = Noise.noise x y z in
      let near n' = abs_float (n' -. n) < 3. *. step in
      if
        not
          (near (Noise.noise (x +. step) y z)
          && near (Noise.noise x (y +. step) z)
          && near (Noise.noise x y (z +. step)))
      then Alcotest.failf "a jump at %h %h %h" x y z)

(* Noise of places far from each other is unrelated, also at the distances at
   which that of a table would repeat; of 20,000 the correlation of unrelated
   numbers is within 0.007 in two cases of three. *)
let test_no_period () =
  let correlation dx dy dz =
    let products = ref 0. and squares = ref 0. in
    for_points 20_000 (fun x y z ->
        let n = Noise.noise x y z in
        let n' = Noise.noise (x +. dx) (y +. dy) (z +. dz) in
        products := !products +. (n *. n');
        squares := !squares +. (n *. n));
    !products /. !squares
  in
  List.iter
    (fun d ->
      let unrelated = Alcotest.(check (float 0.035)) (string_of_float d) 0. in
      unrelated (correlation d 0. 0.);
      unrelated (correlation 0. d 0.);
      unrelated (correlation 0. 0. d);
      unrelated (correlation d d d))
    [ 2.; 16.; 255.; 256.; 257.; 4096.; 65536.; -100000. ]

let test_whole () =
  let zeros = ref 0 in
  for x = -10 to 10 do
    for z = -10 to 10 do
      if abs_float (Noise.noise (float x) 0. (float z)) < 1e-3 then incr zeros
    done
  done;
  Alcotest.(check bool) "few of 441" true (!zeros < 10)

let far =
  let open QCheck2.Gen in
  let point = triple Generate.extreme Generate.extreme Generate.extreme in
  Property.holds ~count:20_000 "everywhere from -1 to 1"
    (pair point (int_range (-3) 40))
    (fun ((x, y, z), octaves) ->
      abs_float (Noise.noise x y z) <= 1.
      && abs_float (Noise.turbulence x y z octaves) <= 1.)

let test_not_finite () =
  check "x" nan (Noise.noise nan 0. 0.);
  check "y" nan (Noise.noise 0. infinity 0.);
  check "z" nan (Noise.noise 0. 0. neg_infinity);
  check "turbulence" nan (Noise.turbulence 0. nan 0. 3)

let test_turbulence () =
  let x = 1.3 and y = -2.6 and z = 0.7 in
  let turbulence = Noise.turbulence x y z in
  check "none" 0. (turbulence 0);
  check "fewer than none" 0. (turbulence (-1));
  check "one" (Noise.noise x y z) (turbulence 1);
  check "beyond 32" (turbulence 32) (turbulence 1000);
  for octaves = 2 to 32 do
    (* one more is at most its share of the sum *)
    let weight = ldexp 1. (1 - octaves) in
    let change = abs_float (turbulence octaves -. turbulence (octaves - 1)) in
    Alcotest.(check bool) "its share" true (change <= 2. *. weight)
  done

let suite =
  ( "Noise",
    [
      Alcotest.test_case "scale" `Quick test_scale;
      Alcotest.test_case "range" `Quick test_range;
      Alcotest.test_case "smooth" `Quick test_smooth;
      Alcotest.test_case "no period" `Quick test_no_period;
      Alcotest.test_case "whole coordinates" `Quick test_whole;
      far;
      Alcotest.test_case "turbulence" `Quick test_turbulence;
      Alcotest.test_case "not finite" `Quick test_not_finite;
    ] )
