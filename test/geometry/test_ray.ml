open Raylab_geometry
open Test_support
open Build

let check_point = Alcotest.check Same.vec3
let check_number = Alcotest.check Same.number

(* (1, 2, 3) + 10 (0.6, 0, 0.8) = (7, 2, 11). *)
let test_at () =
  let ray = ray (v 1. 2. 3.) (v 3. 0. 4.) in
  check_point "origin" (v 1. 2. 3.) (Ray.at ray 0.);
  Alcotest.check (Same.vec3_near 1e-14) "ahead" (v 7. 2. 11.) (Ray.at ray 10.);
  Alcotest.check (Same.vec3_near 1e-14) "behind" (v (-5.) 2. (-5.))
    (Ray.at ray (-10.));
  check_number "no end" infinity (Ray.reach ray)

(* From (1, 1, 1) to (1, 1, 6) it is 5 along z; half of 1 less is 4.5. *)
let test_towards () =
  let towards target = Ray.towards ~origin:(v 1. 1. 1.) ~target ~short:0.5 in
  let ray = Option.get (towards (v 1. 1. 6.)) in
  check_point "direction" (v 0. 0. 1.) (Ray.direction ray :> Vec3.t);
  check_point "origin" (v 1. 1. 1.) (Ray.origin ray);
  check_number "reach" 4.5 (Ray.reach ray);
  Alcotest.(check bool) "coincident" true (towards (v 1. 1. 1.) = None);
  Alcotest.(check bool) "at infinity" true (towards (v infinity 0. 0.) = None);
  Alcotest.(check bool) "nowhere" true (towards (v nan 0. 0.) = None)

let test_towards_far () =
  let reach_at d =
    match Ray.towards ~origin:Vec3.zero ~target:(v d 0. 0.) ~short:0. with
    | Some ray -> Ray.reach ray
    | None -> nan
  in
  check_number "1e150" 1e150 (reach_at 1e150);
  (* |v|^2 overflows, the distance does not *)
  check_number "1e200" 1e200 (reach_at 1e200);
  (* the difference itself overflows *)
  Alcotest.(check bool)
    "further than a double" true
    (Ray.towards ~origin:(v (-.max_float) 0. 0.) ~target:(v max_float 0. 0.)
       ~short:0.
    = None)

(* Down to the right on a floor goes on up to the right, whichever way the
   floor's normal points. *)
let test_reflect () =
  let check what expected ray ~normal =
    Alcotest.check (Same.ray_near 1e-15) what expected
      (Ray.reflect ray ~point:(v 3. 1. 0.) ~normal)
  and down = ray (v 0. 5. 0.) (v 3. (-4.) 0.) in
  let up = ray (v 3. 1. 0.) (v 3. 4. 0.) in
  check "from the floor" up down ~normal:(dir 0. 1. 0.);
  check "whose normal points down" up down ~normal:(dir 0. (-1.) 0.);
  check "head on"
    (ray (v 3. 1. 0.) (v 0. 0. (-1.)))
    (ray Vec3.zero (v 0. 0. 1.))
    ~normal:(dir 0. 0. 1.);
  check "along the surface"
    (ray (v 3. 1. 0.) (v 3. (-4.) 0.))
    down ~normal:(dir 0. 0. 1.);
  let short = Ray.towards ~origin:Vec3.zero ~target:(v 0. 0. 2.) ~short:0. in
  check_number "a reflected ray has no end" infinity
    (Ray.reach
       (Ray.reflect (Option.get short) ~point:Vec3.zero ~normal:(dir 0. 1. 0.)))

let test_pp () =
  Expect.prints "endless" "(0, 0, -4) + t (0, 0, 1)" Ray.pp
    (ray (v 0. 0. (-4.)) (v 0. 0. 1.));
  Expect.prints "with an end" "(0, 0, 1) + t (0, 0, 1), t < 3" Ray.pp
    (Option.get
       (Ray.towards ~origin:(v 0. 0. 1.) ~target:(v 0. 0. 4.) ~short:0.))

let rays_and_normals =
  QCheck2.Gen.pair
    (Generate.ray Generate.everyday)
    (Generate.direction Generate.everyday)

let cross (a : Vec3.t) (b : Vec3.t) =
  v
    ((a.y *. b.z) -. (a.z *. b.y))
    ((a.z *. b.x) -. (a.x *. b.z))
    ((a.x *. b.y) -. (a.y *. b.x))

(* The law of reflection: the angle with the normal is kept, its sign changed;
   the ray stays in the plane of incidence; its direction keeps length 1. *)
let law_of_reflection =
  Property.holds "the law of reflection" ~count:2000 rays_and_normals
    (fun (ray, normal) ->
      let mirrored = Ray.reflect ray ~point:Vec3.zero ~normal in
      let d = (Ray.direction ray :> Vec3.t)
      and d' = (Ray.direction mirrored :> Vec3.t)
      and n = (normal :> Vec3.t) in
      abs_float (Vec3.dot d n +. Vec3.dot d' n) < 1e-14
      && abs_float (Vec3.dot (cross d n) d') < 1e-14
      && abs_float (Vec3.length d' -. 1.) < 1e-14)

let either_side =
  Property.holds "the normal's side makes no difference" rays_and_normals
    (fun (ray, normal) ->
      let direction normal =
        (Ray.direction (Ray.reflect ray ~point:Vec3.zero ~normal) :> Vec3.t)
      in
      Vec3.equal (direction normal) (direction (Direction.neg normal)))

(* d and -d are 2 apart, so a reflection of a reflection is told from one. *)
let involution =
  Property.holds "reflecting twice is nothing" rays_and_normals
    (fun (ray, normal) ->
      let reflect = Ray.reflect ~point:Vec3.zero ~normal in
      let d = (Ray.direction ray :> Vec3.t)
      and back = (Ray.direction (reflect (reflect ray)) :> Vec3.t) in
      Vec3.magnitude (Vec3.sub back d) < 1e-14)

let copies =
  Property.holds "a register of a ray is a copy of it"
    (Generate.ray Generate.extreme) (fun ray ->
      let raw = Ray.to_raw ray in
      let same = Alcotest.equal (Same.ray_near 0.) in
      let read = Ray.of_raw raw and before = Ray.of_raw (ray :> Raw_ray.t) in
      Raw_ray.set_origin raw 1. 2. 3.;
      Raw_ray.set_direction raw 0. 1. 0.;
      raw.reach <- 4.;
      same read before && same ray before)

let suite =
  ( "Ray",
    [
      Alcotest.test_case "at" `Quick test_at;
      Alcotest.test_case "towards" `Quick test_towards;
      Alcotest.test_case "towards, far away" `Quick test_towards_far;
      Alcotest.test_case "reflect" `Quick test_reflect;
      Alcotest.test_case "pp" `Quick test_pp;
      law_of_reflection;
      either_side;
      involution;
      copies;
    ] )
