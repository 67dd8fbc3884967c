open Raylab_geometry
open Raylab_scene
open Test_support
open Build

let vector (d : Direction.t) = (d :> Vec3.t)

let frame { Viewpoint.right; above; forward; _ } =
  (vector right, vector above, vector forward)

let is_near a b = abs_float (a -. b) < 1e-14

let sound name number =
  Property.holds ("the frame is at right angles and left-handed, " ^ name)
    (Generate.viewpoint number) ~print:(Property.show Viewpoint.pp)
    (fun viewpoint ->
      let r, u, f = frame viewpoint in
      List.for_all (fun v -> is_near (Vec3.length v) 1.) [ r; u; f ]
      && List.for_all
           (fun (a, b) -> is_near (Vec3.dot a b) 0.)
           [ (r, u); (u, f); (f, r) ]
      && is_near (Vec3.dot (Vec3.cross r u) f) 1.)

let aligned =
  Property.holds "it looks at the point, and up is up" ~count:1000
    (Generate.viewpoint Generate.everyday) ~print:(Property.show Viewpoint.pp)
    (fun ({ eye; look_at; up; _ } as viewpoint) ->
      let way = Viewpoint.to_frame viewpoint (Vec3.sub look_at eye)
      and up = Viewpoint.to_frame viewpoint up in
      abs_float way.x < 1e-12
      && abs_float way.y < 1e-12
      && way.z > 0.
      && abs_float up.x < 1e-12
      && up.y > 0.)

let inverse =
  Property.holds "to_frame is the inverse of of_frame"
    QCheck2.Gen.(
      pair
        (Generate.viewpoint Generate.everyday)
        (Generate.vec3 Generate.everyday))
    (fun (viewpoint, v) ->
      let same =
        Viewpoint.to_frame viewpoint (Viewpoint.of_frame viewpoint v)
      in
      Vec3.length (Vec3.sub same v) < 1e-13)

let axes =
  Property.holds "that of a camera which is not placed has the axes, exactly"
    (Generate.positive Generate.extreme) (fun depth ->
      let viewpoint = Viewpoint.before_origin depth in
      let is_axis d v = compare (vector d) v = 0 in
      is_axis viewpoint.right (v 1. 0. 0.)
      && is_axis viewpoint.above (v 0. 1. 0.)
      && is_axis viewpoint.forward (v 0. 0. 1.)
      && Viewpoint.distance viewpoint = depth)

let test_known () =
  let check what viewpoint right above forward =
    let r, u, f = frame viewpoint in
    Alcotest.check (Same.vec3_near 1e-15) (what ^ ": right") right r;
    Alcotest.check (Same.vec3_near 1e-15) (what ^ ": above") above u;
    Alcotest.check (Same.vec3_near 1e-15) (what ^ ": forward") forward f
  in
  check "from above, z up"
    (Viewpoint.make_exn ~up:(v 0. 0. 1.) (v 0. 5. 0.))
    (v 1. 0. 0.) (v 0. 0. 1.) (v 0. (-1.) 0.);
  check "from the right"
    (Viewpoint.make_exn (v 7. 0. 0.))
    (v 0. 0. 1.) (v 0. 1. 0.) (v (-1.) 0. 0.);
  check "from behind"
    (Viewpoint.make_exn ~look_at:(v 0. 0. 1.) (v 0. 0. 3.))
    (v (-1.) 0. 0.) (v 0. 1. 0.) (v 0. 0. (-1.))

let test_problems () =
  let problem ?look_at ?up eye =
    match Viewpoint.make ?look_at ?up eye with
    | Ok _ -> "none"
    | Error At_the_eye -> "at the eye"
    | Error Along_up -> "along up"
  in
  let check = Alcotest.(check string) in
  check "at the origin" "at the eye" (problem Vec3.zero);
  check "elsewhere" "at the eye" (problem ~look_at:(v 1. 2. 3.) (v 1. 2. 3.));
  check "from above" "along up" (problem (v 0. 5. 0.));
  check "from below" "along up" (problem (v 0. (-5.) 0.));
  check "askew" "along up" (problem ~up:(v 0.1 0.2 0.3) (v 1. 2. 3.));
  check "nearly" "along up" (problem (v 1e-10 1. 0.));
  check "not quite" "none" (problem (v 1e-8 1. 0.));
  check "far apart" "none"
    (problem ~look_at:(v max_float 0. 0.) (v (-.max_float) 0. 0.));
  Expect.invalid "up" (fun () -> Viewpoint.make ~up:Vec3.zero (v 1. 0. 0.));
  List.iter
    (fun bad ->
      let bad = v 0. bad 1. in
      Expect.invalid "eye" (fun () -> Viewpoint.make bad);
      Expect.invalid "point" (fun () ->
          Viewpoint.make ~look_at:bad (v 1. 0. 0.));
      Expect.invalid "up" (fun () -> Viewpoint.make ~up:bad (v 1. 0. 0.)))
    [ nan; infinity ];
  Expect.invalid "make_exn" (fun () -> Viewpoint.make_exn Vec3.zero)

let suite =
  ( "Viewpoint",
    [
      sound "everyday" Generate.everyday;
      sound "any size" Generate.extreme;
      aligned;
      inverse;
      axes;
      Alcotest.test_case "known ones" `Quick test_known;
      Alcotest.test_case "problems" `Quick test_problems;
    ] )
