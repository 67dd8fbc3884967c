open Raylab_scene
open Raylab_tracer
open Test_support
open Build

let steps scene (x, y) =
  Explain.steps scene (Sample_ray.make scene.Prepared.scene ~x ~y 0)

(* Numbers that are not numbers are equal here, too. *)
let is_same a b = compare a b = 0

let ends =
  Any.holds "the last step has the root's colour" (fun scene ->
      List.for_all
        (fun (pixel, (e : Explain.t)) ->
          match List.rev (List.of_seq (steps scene pixel)) with
          | Done color :: _ -> is_same color e.color
          | _ -> false)
        (Any.explanations scene))

let persistent =
  Any.holds "read again, they are the same" (fun scene ->
      List.for_all
        (fun pixel ->
          let all = steps scene pixel in
          let once = List.of_seq all in
          let rest =
            match all () with Nil -> Seq.empty | Cons (_, rest) -> rest
          in
          is_same once (List.of_seq all)
          && is_same (List.tl once) (List.of_seq rest)
          && is_same (List.tl once) (List.of_seq rest))
        (Any.pixels scene))

(* A mirror before a wall behind the eye, which one light reaches, one does not,
   and from which the wall is turned away. *)
let test_order () =
  let lights =
    [
      Light.directional ~intensity:1. ~color:Color.white
        ~direction:(v 0. 0. (-1.));
      Light.spherical ~intensity:9. ~color:Color.white
        ~position:(v 0. 5. (-5.));
      Light.directional ~intensity:1. ~color:Color.white
        ~direction:(v 0. 0. 1.);
    ]
  in
  let objects =
    [
      plane (v 0. 0. 4.) (v 0. 0. 1.) Surface.reflective;
      plane (v 0. 0. (-9.)) (v 0. 0. 1.) (Surface.diffusive Color.white);
    ]
  in
  let scene = Prepared.make (Scene.make ~lights ~objects (camera ())) in
  let word (event : Event.t) =
    match event with
    | Opened { role = Primary; left; _ } -> Printf.sprintf "cast %d" left
    | Opened { role = Mirrored; left; _ } -> Printf.sprintf "bounce %d" left
    | Opened { role = Refracted; left; _ } -> Printf.sprintf "refract %d" left
    | Met { number; _ } -> Printf.sprintf "hit %d" number
    | Faces_away { light; _ } -> Printf.sprintf "away %d" light
    | Outside { light; _ } -> Printf.sprintf "outside %d" light
    | Mean { light; _ } -> Printf.sprintf "mean %d" light
    | Shadow_ray { light; _ } -> Printf.sprintf "shadow %d" light
    | Blocked { light; by; _ } -> Printf.sprintf "blocked %d by %d" light by
    | Lit { light; _ } -> Printf.sprintf "lit %d" light
    | Closed { terms = [ { source = Background; _ } ]; _ } -> "background"
    | Closed _ -> "mix"
    | Done _ -> "done"
  in
  Alcotest.(check (list string))
    "in the tracer's order"
    [
      "cast 4";
      "hit 1";
      "bounce 3";
      "hit 2";
      "shadow 1";
      "blocked 1 by 1";
      "shadow 2";
      "lit 2";
      "away 3";
      "mix";
      "mix";
      "done";
    ]
    (List.of_seq (Seq.map word (steps scene (0, 0))))

let suite =
  ("Steps", (Alcotest.test_case "order" `Quick test_order :: ends) @ persistent)
