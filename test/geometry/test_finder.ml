open Raylab_geometry
open Test_support
open Build

let ball z = Shape.sphere ~centre:(v 0. 0. z) ~radius:1.
let wall z = Shape.plane ~point:(v 0. 0. z) ~normal:(v 0. 0. 1.)
let z_axis = ray Vec3.zero (v 0. 0. 1.)

let up_to z =
  Option.get (Ray.towards ~origin:Vec3.zero ~target:(v 0. 0. z) ~short:0.)

let ask index shapes ray =
  let { Finder.nearest; blocked } = Index.ask (index (Array.of_list shapes))
  and meeting = Meeting.create () in
  (* what was met before makes no difference *)
  meeting.number <- 0;
  nearest (Ray.to_raw ray) meeting;
  (meeting.number, blocked 0 (Ray.to_raw ray))

let check what shapes ray expected =
  let nearest, blocked = ask Index.brute_force shapes ray in
  Alcotest.(check int) (what ^ ", nearest") expected nearest;
  Alcotest.(check bool) (what ^ ", blocked") (expected <> Meeting.none) blocked

let none = Meeting.none

let test_nearest () =
  Alcotest.(check int) "no shape" (-1) none;
  check "nothing there" [] z_axis none;
  check "the nearer of three" [ ball 9.; wall 3.; ball 6. ] z_axis 1;
  check "behind does not count" [ ball (-3.); ball 6. ] z_axis 1;
  check "only behind" [ ball (-3.); wall (-1.) ] z_axis none;
  (* the sphere is left at 4, the wall stands at 3 *)
  check "from inside"
    [ Shape.sphere ~centre:Vec3.zero ~radius:4.; wall 3. ]
    z_axis 1

(* A wall at 5 and the unit sphere around 6 are both met at exactly 5. *)
let test_ties () =
  check "sphere first" [ ball 6.; wall 5. ] z_axis 0;
  check "wall first" [ wall 5.; ball 6. ] z_axis 0;
  check "after others" [ wall 9.; ball 6.; wall 5.; ball 6. ] z_axis 1

let test_reach () =
  check "before its end" [ wall 5. ] (up_to 5.5) 0;
  check "at its end" [ wall 5. ] (up_to 5.) none;
  check "after its end" [ wall 5. ] (up_to 4.5) none;
  check "sphere at its end" [ ball 6. ] (up_to 5.) none;
  check "the other one" [ wall 5.; wall 3. ] (up_to 5.) 1

let shapes_and_rays number =
  QCheck2.Gen.pair
    (QCheck2.Gen.list_size (QCheck2.Gen.int_range 0 8) (Generate.shape number))
    (Generate.ray number)

(* Said once more, in the slowest way: of all positive intersections of all
   shapes the least, and the first shape that has it. NaN is none of them. *)
let by_definition shapes ray =
  let hits number shape =
    List.filter_map
      (fun t -> if t > 0. && t < Ray.reach ray then Some (t, number) else None)
      (Shape.intersections shape ray)
  in
  match List.sort compare (List.concat (List.mapi hits shapes)) with
  | [] -> none
  | (_, number) :: _ -> number

let agrees (shapes, ray) =
  let expected = by_definition shapes ray in
  ask Index.brute_force shapes ray = (expected, expected <> none)

let everyday =
  Property.holds "nearest is the least of all hits" ~count:2000
    (shapes_and_rays Generate.everyday)
    agrees

let extreme =
  Property.holds "so with numbers of any size" ~count:2000
    (shapes_and_rays Generate.extreme)
    agrees

(* Rays whose origin is not a point meet nothing. *)
let not_a_number =
  Property.holds "NaN is never a hit" ~count:2000
    QCheck2.Gen.(
      triple
        (list_size (int_range 1 8) (Generate.shape Generate.extreme))
        (Generate.direction Generate.everyday)
        (int_bound 2))
    (fun (shapes, direction, axis) ->
      let part k = if k = axis then nan else 1. in
      let origin = v (part 0) (part 1) (part 2) in
      let ray = Ray.make ~origin ~direction in
      ask Index.brute_force shapes ray = (none, false))

let suite =
  ( "Finder",
    [
      Alcotest.test_case "nearest" `Quick test_nearest;
      Alcotest.test_case "ties" `Quick test_ties;
      Alcotest.test_case "reach" `Quick test_reach;
      everyday;
      extreme;
      not_a_number;
    ] )
