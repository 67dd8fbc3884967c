open Raylab_geometry
open Test_support
open Build

let facets ?(normals = [||]) ?(corner_normals = [||]) points corners =
  let count = Array.length corners / 3 in
  {
    Facets.points;
    normals;
    corners;
    corner_normals;
    faces = Array.init count (fun k -> k + 1);
    places = Array.init count (fun k -> 10 * k);
    in_bytes = false;
  }

let mesh facets = Mesh.make ~name:"test.obj" facets

(* The cube from (0, 0, 0) to (2, 2, 2). Corner k has a coordinate of 2 where k
   has a bit; faces are wound so that (B - A) x (C - A) points outward. *)
let cube =
  let points =
    Array.init 24 (fun i ->
        if ((i / 3) lsr (i mod 3)) land 1 = 1 then 2. else 0.)
  and quad a b c d = [ a; b; c; a; c; d ] in
  let corners =
    quad 0 4 6 2 @ quad 1 3 7 5 @ quad 0 1 5 4 @ quad 2 6 7 3 @ quad 0 2 3 1
    @ quad 4 5 7 6
  in
  facets points (Array.of_list corners)

let hit ?(any = mesh cube) (origin : Vec3.t) (toward : Vec3.t) =
  let ray = Raw_ray.create () and meeting = Meeting.create () in
  let d = (Direction.of_vec3_exn (Vec3.sub toward origin) :> Vec3.t) in
  Raw_ray.set_origin ray origin.x origin.y origin.z;
  Raw_ray.set_direction ray d.x d.y d.z;
  Mesh.offer any ray meeting ~number:0;
  if Meeting.is_none meeting then None else Some (ray, meeting.part)

let crossed any (origin : Vec3.t) (toward : Vec3.t) =
  let ray = Raw_ray.create () and found = Crossings.create () in
  let d = (Direction.of_vec3_exn (Vec3.sub toward origin) :> Vec3.t) in
  Raw_ray.set_origin ray origin.x origin.y origin.z;
  Raw_ray.set_direction ray d.x d.y d.z;
  Mesh.crossings any ray found;
  Crossings.to_list found

let distance = Option.map (fun ((ray : Raw_ray.t), _) -> ray.reach)
let number = Same.number

let test_hit () =
  let check what expected found =
    Alcotest.(check (option number)) what expected (distance found)
  in
  check "the front" (Some 3.) (hit (v 0.5 0.7 (-3.)) (v 0.5 0.7 0.));
  check "from inside" (Some 1.5) (hit (v 0.5 0.7 0.5) (v 0.5 0.7 2.));
  check "beside it" None (hit (v 2.5 0.7 (-3.)) (v 2.5 0.7 0.));
  check "behind" None (hit (v 0.5 0.7 (-3.)) (v 0.5 0.7 (-4.)));
  (* the front is cut along the line from (0, 0, 0) to (2, 2, 0) *)
  check "where two triangles meet" (Some 3.) (hit (v 1. 1. (-3.)) (v 1. 1. 0.))

let test_spot () =
  match hit (v 0.5 0.7 (-3.)) (v 0.5 0.7 0.) with
  | None -> Alcotest.fail "no hit"
  | Some (ray, part) ->
      let spot = Spot.create () in
      Mesh.settle (mesh cube) ~part ray spot;
      Alcotest.check Same.vec3 "point" (v 0.5 0.7 0.) (Spot.point spot);
      Alcotest.check Same.vec3 "own point" (v 0.5 0.7 0.) (Spot.own spot);
      Alcotest.check Same.vec3 "normal" (v 0. 0. (-1.))
        (Spot.normal spot :> Vec3.t)

let test_whole () =
  let cube = mesh cube in
  Alcotest.(check bool) "closed" true (Mesh.is_closed cube);
  Alcotest.check number "volume" 8. (Mesh.volume cube);
  Alcotest.(check string)
    "box" "(0, 0, 0) to (2, 2, 2)"
    (Format.asprintf "%a" Box3.pp (Mesh.box cube));
  let check what expected point =
    Alcotest.check number what expected (Mesh.depth cube point)
  in
  check "depth in the middle" 1. (v 1. 1. 1.);
  check "depth off it" 0.25 (v 1. 0.25 1.);
  check "depth outside" (-5.) (v 5. 6. 2.)

let turned (f : Facets.t) =
  let corner k =
    (* the second and the third change places *)
    f.corners.(match k mod 3 with 0 -> k | 1 -> k + 1 | _ -> k - 1)
  in
  { f with corners = Array.mapi (fun k _ -> corner k) f.corners }

let without_first count (f : Facets.t) =
  let rest array size =
    Array.sub array (size * count) (Array.length array - (size * count))
  in
  {
    f with
    corners = rest f.corners 3;
    faces = rest f.faces 1;
    places = rest f.places 1;
  }

let test_survey () =
  let check what expected facets =
    let { Mesh_survey.normals; _ } = Mesh_survey.make (mesh facets) in
    Alcotest.(check bool) what true (normals = expected)
  in
  check "a cube" Outward cube;
  check "turned inside out" Inward (turned cube);
  check "an open one" Outward (without_first 2 cube);
  check "an open one, turned" Inward (turned (without_first 2 cube));
  check "a side of it" (Along (dir 0. 0. 1.)) (without_first 10 cube);
  Alcotest.(check string)
    "in words"
    "12 triangles from (0, 0, 0) to (2, 2, 2), closed; its normals point \
     outward"
    (Mesh_survey.to_string (Mesh_survey.make (mesh cube)))

let without_last (f : Facets.t) =
  let count = Facets.count f - 1 in
  {
    f with
    corners = Array.sub f.corners 0 (3 * count);
    faces = Array.sub f.faces 0 count;
    places = Array.sub f.places 0 count;
  }

let test_open () =
  let open_cube = mesh (without_last cube) in
  Alcotest.(check (option string))
    "a neighbour of what is missing"
    (Some
       "face 1 (line 0 of test.obj) has an edge from (0, 0, 2) to (0, 2, 2) \
        that no other face has")
    (Mesh.opening open_cube);
  Alcotest.(check int)
    "in and out at each place" 4
    (List.length (crossed open_cube (v 1. 0.9 (-3.)) (v 1. 0.9 0.)));
  Alcotest.check number "no depth" neg_infinity
    (Mesh.depth open_cube (v 1. 1. 1.))

(* Points that are written once for each triangle are still one. *)
let apart (f : Facets.t) =
  {
    f with
    points =
      Array.concat
        (List.map
           (fun k -> Array.sub f.points (3 * k) 3)
           (Array.to_list f.corners));
    corners = Array.init (Array.length f.corners) Fun.id;
  }

let test_apart () =
  Alcotest.(check bool)
    "closed by position" true
    (Mesh.is_closed (mesh (apart cube)))

let test_smooth () =
  (* the normals at the corners of a triangle lean outward *)
  let f =
    facets
      ~normals:[| -1.; 0.; -1.; 1.; 0.; -1.; 0.; 1.; -1. |]
      ~corner_normals:[| 0; 2; 1 |]
      [| -1.; 0.; 0.; 1.; 0.; 0.; 0.; 2.; 0. |]
      [| 0; 2; 1 |]
  in
  let f = { f with normals = Array.map (fun x -> x *. sqrt 0.5) f.normals } in
  let m = Mesh.smooth f (mesh f) in
  match hit ~any:m (v 0.25 0.5 (-2.)) (v 0.25 0.5 0.) with
  | None -> Alcotest.fail "no hit"
  | Some (ray, part) ->
      let spot = Spot.create () in
      Mesh.settle m ~part ray spot;
      Spot.turn_to spot ray;
      (* weights 1/4, 1/2, 1/4: along (1/4, 1/4, -1) *)
      let expected = (Direction.of_vec3_exn (v 1. 1. (-4.)) :> Vec3.t) in
      Alcotest.check (Same.vec3_near 1e-12) "shading" expected
        (v spot.shading_x spot.shading_y spot.shading_z);
      Alcotest.check Same.vec3 "flat" (v 0. 0. (-1.))
        (Spot.normal spot :> Vec3.t)

(* {1 No ray slips through} *)

(* A closed surface of n x n quads with bumps, around the origin: a torus. *)
let torus n =
  let tau = 8. *. atan 1. in
  let at i = tau *. float_of_int i /. float_of_int n in
  let point k =
    let u = at (k / n) and w = at (k mod n) in
    let r = 1. +. (0.4 *. cos w *. (1. +. (0.1 *. sin (5. *. u)))) in
    [ r *. cos u; 0.4 *. sin w; r *. sin u ]
  in
  let corner i j = (i mod n * n) + (j mod n) in
  let quad k =
    let i = k / n and j = k mod n in
    let a = corner i j and b = corner (i + 1) j in
    let c = corner (i + 1) (j + 1) and d = corner i (j + 1) in
    [ a; b; c; a; c; d ]
  in
  facets
    (Array.of_list (List.concat_map point (List.init (n * n) Fun.id)))
    (Array.of_list (List.concat_map quad (List.init (n * n) Fun.id)))

let bumpy = torus 16
let bumpy_mesh = mesh bumpy

(* A corner or the middle of an edge, with coordinates that are no round
   numbers. *)
let place_on_edge =
  QCheck2.Gen.(
    let* corner = int_bound (Array.length bumpy.corners - 1) in
    let first = corner - (corner mod 3) in
    let next = first + ((corner + 1) mod 3) in
    let point k =
      let p = 3 * bumpy.corners.(k) in
      v bumpy.points.(p) bumpy.points.(p + 1) bumpy.points.(p + 2)
    in
    let* along = oneofl [ 0.; 0.5; 0.25 ] in
    return
      (Vec3.add
         (Vec3.scale (1. -. along) (point corner))
         (Vec3.scale along (point next))))

let far =
  QCheck2.Gen.(
    let* x = float_range (-1.) 1. and* y = float_range (-1.) 1. in
    let* z = float_range (-1.) 1. in
    return
      (Vec3.scale 5.
         (Direction.of_vec3_or (Direction.of_vec3_exn (v 1. 0. 0.)) (v x y z)
           :> Vec3.t)))

(* Also along the axes, where rays meet edges exactly. *)
let ray_to_edge =
  QCheck2.Gen.(
    let* place = place_on_edge in
    let* away =
      oneof [ far; oneofl [ v 0. 0. (-4.); v 0. 5. 0.; v (-3.) 0. 0. ] ]
    in
    return (Vec3.add place away, place))

let never_through =
  Property.holds "who aims at an edge from outside enters and leaves by turns"
    ~count:3000 ray_to_edge (fun (origin, toward) ->
      let found = crossed bumpy_mesh origin toward in
      let rec ascend = function
        | (a : Crossings.crossing) :: (b :: _ as rest) ->
            a.t <= b.t && ascend rest
        | _ -> true
      in
      List.length found mod 2 = 0 && ascend found)

let nearest_is_least =
  Property.holds "the nearest is the least crossing in front" ~count:3000
    ray_to_edge (fun (origin, toward) ->
      let ahead =
        List.filter
          (fun (c : Crossings.crossing) -> c.t > 0.)
          (crossed bumpy_mesh origin toward)
      in
      let least = match ahead with [] -> None | c :: _ -> Some c.t in
      distance (hit ~any:bumpy_mesh origin toward) = least)

let triangles_alone =
  lazy
    (List.init (Facets.count bumpy) (fun part ->
         mesh
           {
             bumpy with
             corners = Array.sub bumpy.corners (3 * part) 3;
             faces = [| 1 |];
             places = [| 1 |];
           }))

let tree_is_brute_force =
  Property.holds "the tree is brute force" ray_to_edge (fun (origin, toward) ->
      let nearer least any =
        Float.min least
          (Option.value ~default:infinity (distance (hit ~any origin toward)))
      in
      let least =
        List.fold_left nearer infinity (Lazy.force triangles_alone)
      in
      Option.value ~default:infinity
        (distance (hit ~any:bumpy_mesh origin toward))
      = least)

let inside_from_any_side =
  let on_ring = QCheck2.Gen.(float_range 0. 6.28) in
  Property.holds "a point on the ring is inside, one above it outside"
    ~count:300 on_ring (fun u ->
      Mesh.depth bumpy_mesh (v (cos u) 0. (sin u)) > 0.2
      && Mesh.depth bumpy_mesh (v (cos u) 0.45 (sin u)) < 0.)

let test_refused () =
  let refused what f =
    match mesh f with
    | _ -> Alcotest.fail what
    | exception Invalid_argument _ -> ()
  in
  refused "no triangle" (facets [| 0.; 0.; 0. |] [||]);
  refused "no such point" (facets [| 0.; 0.; 0. |] [| 0; 0; 1 |]);
  refused "not finite" (facets [| nan; 0.; 0. |] [| 0; 0; 0 |]);
  match Mesh.smooth cube (mesh cube) with
  | _ -> Alcotest.fail "smooth without normals"
  | exception Invalid_argument _ -> ()

let suite =
  ( "Mesh",
    [
      Alcotest.test_case "hits" `Quick test_hit;
      Alcotest.test_case "spots" `Quick test_spot;
      Alcotest.test_case "as a whole" `Quick test_whole;
      Alcotest.test_case "open" `Quick test_open;
      Alcotest.test_case "surveys" `Quick test_survey;
      Alcotest.test_case "points apart" `Quick test_apart;
      Alcotest.test_case "smooth" `Quick test_smooth;
      Alcotest.test_case "refused" `Quick test_refused;
      never_through;
      nearest_is_least;
      tree_is_brute_force;
      inside_from_any_side;
    ] )
