open Raylab_geometry
open Raylab_scene
open Test_support
open Build

let color = Color.white
let normal = dir 0. 1. 0.
let check_ray = Alcotest.check (Same.ray_near 1e-14)

(* Against the light's direction, from 0.1 above the point, without end. *)
let test_directional () =
  let sun =
    Light.directional ~intensity:1. ~color ~direction:(v 3. (-4.) 0.)
  in
  check_ray "upwards"
    (ray (v 5. 0.1 0.) (v (-3.) 4. 0.))
    (Option.get
       (Incidence.shadow_ray sun ~point:(v 5. 0. 0.) ~normal ~offset:0.1))

(* Whether what a shadow ray meets at distance [t] is in the way of the
   light. *)
let blocks shadow_ray t =
  let meeting = Meeting.create () in
  Meeting.offer meeting (Ray.to_raw shadow_ray) ~number:0 ~part:0 t;
  not (Meeting.is_none meeting)

(* From (0, 0.1, 0) to (0, 4, 0) it is 3.9; 0.1 of it is left out. *)
let test_point () =
  let bulb = Light.spherical ~intensity:1. ~color ~position:(v 0. 4. 0.) in
  let shadow_ray =
    Option.get (Incidence.shadow_ray bulb ~point:Vec3.zero ~normal ~offset:0.1)
  in
  Alcotest.check (Same.near 1e-14) "reach" 3.8 (Ray.reach shadow_ray);
  Alcotest.check Same.vec3 "towards the light" (v 0. 1. 0.)
    (Ray.direction shadow_ray :> Vec3.t);
  let check what expected t =
    Alcotest.(check bool) what expected (blocks shadow_ray t)
  in
  check "between" true 2.;
  check "just before its end" true (Float.pred (Ray.reach shadow_ray));
  check "at its end" false (Ray.reach shadow_ray);
  check "behind the light" false 5.;
  check "at the point" false 0.;
  check "before the point" false (-1.);
  check "NaN" false nan;
  check "never" false infinity

let test_endless () =
  let sun =
    Light.directional ~intensity:1. ~color ~direction:(v 0. (-1.) 0.)
  in
  let shadow_ray =
    Option.get (Incidence.shadow_ray sun ~point:Vec3.zero ~normal ~offset:0.1)
  in
  Alcotest.(check bool) "far away" true (blocks shadow_ray 1e300);
  Alcotest.(check bool) "never" false (blocks shadow_ray infinity)

let test_none () =
  let bulb = Light.spherical ~intensity:1. ~color ~position:(v 0. 0.5 0.) in
  Alcotest.(check bool)
    "the light is where the ray starts" true
    (Incidence.shadow_ray bulb ~point:Vec3.zero ~normal ~offset:0.5 = None)

let test_far () =
  let shadow_ray y =
    let light = Light.spherical ~intensity:1. ~color ~position:(v 0. y 0.) in
    Incidence.shadow_ray light ~point:Vec3.zero ~normal ~offset:0.
  in
  Alcotest.check (Same.near 1e140) "as far as squares reach" 1e153
    (Ray.reach (Option.get (shadow_ray 1e153)));
  Alcotest.(check bool) "farther" true (shadow_ray 1e155 = None);
  Alcotest.(check bool) "very far" true (shadow_ray max_float = None)

let places =
  QCheck2.Gen.(
    triple
      (Generate.vec3 Generate.everyday)
      (Generate.direction Generate.everyday)
      (float_range 0. 0.1))

(* However the register was used before. *)
let aimed light ~point ~normal ~offset =
  let raw = Raw_ray.create () in
  raw.reach <- 0.;
  let spot = Spot.of_point ~point ~normal ~offset in
  let incidence = Incidence.create () in
  ignore (Incidence.meet light 0 raw spot incidence : bool);
  Spot.start spot raw;
  if Incidence.aim light incidence spot raw then Some (Ray.of_raw raw)
  else None

(* By the light's own numbers: the ray starts off the point, goes against the
   light's direction or to its position, and ends [offset] before that. *)
let aims =
  Property.holds "from the offset point to the light" ~count:2000
    QCheck2.Gen.(pair (Generate.light Generate.everyday) places)
    (fun (light, (point, normal, offset)) ->
      let start = Vec3.add point (Vec3.scale offset (normal :> Vec3.t)) in
      let near a b = Vec3.length (Vec3.sub a b) < 1e-12 in
      match (aimed light ~point ~normal ~offset, light.source) with
      | None, _ -> false
      | Some ray, Directional along ->
          near (Ray.origin ray) start
          && Vec3.equal
               (Vec3.neg (along :> Vec3.t))
               (Ray.direction ray :> Vec3.t)
          && Ray.reach ray = infinity
      | Some ray, source ->
          let goes_to =
            match source with
            | Spherical position | Spot { position; _ } -> near position
            | Area pane ->
                let { Pane.corner; edge; other; _ } = pane in
                let u = Pane.across pane 0 ~seed:0.
                and v = Pane.along pane 0 ~seed:0. in
                near Vec3.Infix.(corner + (u * edge) + (v * other))
            | Directional _ -> fun _ -> false
          in
          near (Ray.origin ray) start
          && goes_to (Ray.at ray (Ray.reach ray +. offset))
          && abs_float (Vec3.length (Ray.direction ray :> Vec3.t) -. 1.)
             < 1e-14)

let one_mathematics =
  Property.holds "shadow_ray is aim, whatever the numbers" ~count:2000
    QCheck2.Gen.(
      triple
        (Generate.light Generate.extreme)
        (Generate.vec3 Generate.extreme)
        (Generate.direction Generate.extreme))
    (fun (light, point, normal) ->
      let offset = 1e-5 in
      let pure = Incidence.shadow_ray light ~point ~normal ~offset in
      compare pure (aimed light ~point ~normal ~offset) = 0)

let suite =
  ( "Shadow rays",
    [
      Alcotest.test_case "directional" `Quick test_directional;
      Alcotest.test_case "point" `Quick test_point;
      Alcotest.test_case "endless" `Quick test_endless;
      Alcotest.test_case "none" `Quick test_none;
      Alcotest.test_case "far" `Quick test_far;
      aims;
      one_mathematics;
    ] )
