(* The hierarchy must answer as the plainest index does, shape for shape. *)

open Raylab_geometry
open Test_support

let answers index rays =
  let { Finder.nearest; blocked } = Index.ask index
  and meeting = Meeting.create () in
  List.map
    (fun ray ->
      let asked = Ray.to_raw ray in
      nearest asked meeting;
      let met =
        if Meeting.is_none meeting then None
        else Some (meeting.number, meeting.part, asked.reach)
      in
      (met, blocked 0 (Ray.to_raw ray)))
    rays

let shapes_and_rays sizes number =
  QCheck2.Gen.(
    pair
      (array_size sizes (Generate.shape number))
      (list_size (1 -- 30) (Generate.ray number)))

let agrees (shapes, rays) =
  answers (Index.hierarchy shapes) rays
  = answers (Index.brute_force shapes) rays

(* Corners and centres of a grid: many at the same distance, rays along faces
   of boxes. *)
let on_a_grid =
  QCheck2.Gen.(
    let cell = map float_of_int (-3 -- 3) in
    pair
      (array_size (0 -- 60)
         (map3
            (fun is_box centre radius ->
              if is_box then
                let far = Vec3.make radius radius radius in
                Shape.box_between ~corner:centre
                  ~opposite:(Vec3.add centre far)
              else Shape.sphere ~centre ~radius)
            bool (Generate.vec3 cell)
            (oneofl [ 0.5; 1.; 2. ])))
      (list_size (1 -- 30) (Generate.ray cell)))

let sphere x y z radius = Shape.sphere ~centre:(Vec3.make x y z) ~radius

let some_rays =
  QCheck2.Gen.generate ~n:300
    ~rand:(Random.State.make [| 5 |])
    (Generate.ray Generate.everyday)

let check_same name ?domains shapes =
  let found = answers (Index.hierarchy ?domains shapes) some_rays in
  Alcotest.(check bool)
    name true
    (found = answers (Index.brute_force shapes) some_rays)

(* What gives a heuristic nothing to hold on to. *)
let test_degenerate () =
  check_same "nothing" [||];
  check_same "one sphere" [| sphere 0. 0. 3. 1. |];
  check_same "one centre"
    (Array.init 20_000 (fun k ->
         sphere 0. 0. 3. (1. +. (float_of_int k /. 1e5))));
  check_same "all alike" (Array.make 20_000 (sphere 0. 0. 3. 1.));
  check_same "each twice as far as the last"
    (Array.init 900 (fun k -> sphere 0. 0. (ldexp 1. (k - 400)) 0.1));
  let small k =
    sphere
      (float_of_int (k mod 100) /. 10.)
      (float_of_int (k / 100) /. 10.)
      4. 0.04
  in
  check_same "one around all"
    (Array.init 10_001 (fun k ->
         if k = 0 then sphere 0. 0. 0. 1e6 else small k))

(* Enough spheres for the tree to be built in parts. *)
let test_domains () =
  let state = Random.State.make [| 11 |] in
  let number () = Random.State.float state 20. -. 10. in
  let shapes =
    Array.init 60_000 (fun _ ->
        sphere (number ()) (number ()) (number ()) 0.05)
  in
  check_same "four domains" ~domains:4 shapes

let print (shapes, rays) =
  Format.asprintf "%a@.%a"
    (Format.pp_print_list Shape.pp)
    (Array.to_list shapes)
    (Format.pp_print_list Ray.pp)
    rays

let holds name count gen = Property.holds name ~count ~print gen agrees

let suite =
  ( "Bvh",
    [
      Alcotest.test_case "degenerate" `Quick test_degenerate;
      Alcotest.test_case "in parts" `Quick test_domains;
      holds "as brute force" 500
        (shapes_and_rays QCheck2.Gen.(0 -- 80) Generate.everyday);
      holds "of many" 20
        (shapes_and_rays (QCheck2.Gen.pure 2000) Generate.everyday);
      holds "on a grid" 500 on_a_grid;
      holds "with numbers of any size" 1000
        (shapes_and_rays QCheck2.Gen.(0 -- 40) Generate.extreme);
    ] )
