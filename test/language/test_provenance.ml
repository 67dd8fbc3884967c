open Raylab_scene
open Raylab_language

let told scene origin =
  Option.fold ~none:"nowhere" ~some:Provenance.to_string
    (Scene.provenance scene origin)

(* What is said of the objects of a scene, whose first line is the header. *)
let check name expected text =
  Alcotest.test_case name `Quick (fun () ->
      let scene = Read.scene (Read.with_header text) in
      let objects =
        List.map (fun o -> told scene o.Object.origin) scene.objects
      and lights =
        List.map (fun l -> told scene l.Light.origin) scene.lights
      in
      Alcotest.(check (list string)) name expected (lights @ objects))

let objects =
  [
    check "written out" [ "line 2"; "line 3" ]
      {|spherical 1 white 0 5 0
sphere 0 0 6 1 reflective|};
    check "with a computed number" [ "line 2" ] "sphere 0 0 (6) 1 reflective";
    check "in a loop"
      [ "line 3, i = 1, line 2"; "line 3, i = 2, line 2" ]
      {|for i = 1 to 2
  sphere i 0 6 0.1 reflective
end|};
    check "on one line" [ "line 2, i = 1" ]
      "for i = 1 to 1 sphere 0 0 6 1 reflective end";
    check "a light"
      [ {|line 2, c = [1, 0, 0]|} ]
      "for c in [[1, 0, 0]] spherical 1 [c] 0 5 0 end";
    check "in a call in a round"
      [ "line 2, in ball(r: 2, name: \"a\"), i = 4, line 3" ]
      {|let ball(r, name: "", of: 1) = sphere 0 0 9 r reflective
for i = 4 to 4
  ball(i / 2, name: "a")
end|};
    check "in a call within a call"
      [ "line 3, in inner(s: a surface), in outer(f: inner), line 5" ]
      {|let matt = diffusive white
let inner(s) = sphere 0 0 6 1 s
let outer(f) = f(matt)
outer(inner)|};
    check "placed by its name"
      [
        "line 2, placed as ball in line 4, i = 0, line 3";
        "line 2, placed as ball in line 4, i = 1, line 3";
      ]
      {|let ball = sphere 0 0 6 1 reflective
for i = 0 to 1
  ball translated (3 * i) 0 0
end|};
    check "in a group that is placed"
      [
        "line 3, i = 0, placed as pair in line 4";
        "line 3, i = 1, placed as pair in line 4";
      ]
      {|let pair = group
  for i = 0 to 1 sphere (3 * i) 0 6 1 reflective end end
pair|};
    check "what is around both is told once"
      [ "line 3, placed as ball in line 4, i = 0, line 2" ]
      {|for i = 0 to 0
  let ball = sphere 0 0 6 1 reflective
  ball
end|};
    check "returned by a call"
      [ "line 2, placed as pick(1) in line 4" ]
      {|let ball = sphere 0 0 6 1 reflective
let pick(k) = (if k = 1 then ball else ball)
pick(1)|};
    check "deep"
      [
        "line 2, in f(n: 0), in f(n: 1), ... 3 more ..., in f(n: 5), in f(n: \
         6), line 3";
      ]
      {|let f(n) = group if (n > 0) f(n - 1) else sphere 0 0 6 1 reflective end end
f(6)|};
  ]

(* All that is made in a round shares what is said of it. *)
let test_sharing () =
  let text =
    {|for i = 1 to 1 for j = 1 to 2 sphere 0 j 6 0.1 reflective
sphere 0 (j) 9 0.1 reflective end end|}
  in
  let scene = Read.scene (Read.with_header text) in
  let trail (o : Object.t) =
    match o.origin with
    | Origin.Made { within; _ } -> within
    | _ -> Alcotest.fail "not made in a round"
  in
  match List.map trail scene.objects with
  | [ a; b; c; _ ] ->
      let around = Raylab_expression.Trail.around in
      Alcotest.(check bool) "of a round" true (a == b);
      Alcotest.(check bool) "of another round" false (a == c);
      Alcotest.(check bool) "around both" true (around a == around c)
  | _ -> Alcotest.fail "not four objects"

let test_data () =
  let scene =
    Read.scene
      (Read.with_header
         {|let s(f) = sphere 0 0 f(1) 1 reflective
let six(x) = (6 * x)
for i = 1 to 3 s(six) translated i 0 0 end|})
  in
  let copy = Marshal.from_string (Marshal.to_string scene []) 0 in
  Alcotest.(check bool) "marshalled" true (compare scene copy = 0)

(* {1 Errors} *)

let advice text =
  match Read.errors (Read.with_header text) with
  | [ error ] -> String.split_on_char '\n' error.Scene_error.advice
  | errors -> Alcotest.failf "%d errors" (List.length errors)

let test_deep_error () =
  let call n line = Printf.sprintf "in f(n: %d), called in line %d" n line in
  Alcotest.(check (list string))
    "both ends"
    (List.init 5 (fun n -> call n 2)
    @ [ "and 13 more between these and" ]
    @ [ call 18 2; call 19 2; call 20 3 ])
    (advice
       {|let f(n) = group if (n > 0) f(n - 1) else sphere 0 0 6 (n) reflective end end
f(20)|});
  Alcotest.(check (list string))
    "all"
    (List.init 7 (fun n -> call n 2) @ [ call 7 3 ])
    (advice
       {|let f(n) = group if (n > 0) f(n - 1) else sphere 0 0 6 (n) reflective end end
f(7)|})

(* Lists in lists, each four times in the next: 4^60 numbers. *)
let test_vast_value () =
  let lines =
    advice
      {|let f(n, l) = group if (n > 0) f(n - 1, [l, l, l, l]) else sphere 0 0 6 (n) reflective end end
f(60, 1)|}
  in
  Alcotest.(check string)
    "the innermost"
    "in f(n: 0, l: [[a list of 4, a list of 4, a list of 4, a list of 4], [a \
     list of 4, a list of 4, a list of 4, a list of 4], [a list of 4, a list \
     of 4, a list of 4, a list of 4], [a list of 4, a list of 4, a list of 4, \
     a list of 4]]), called in line 2"
    (List.hd lines)

(* {1 Names that take over a word} *)

let test_taken () =
  let reading text =
    let sources =
      Raylab_source.Sources.make ~name:"a.scene" (Read.with_header text)
    in
    let file = Raylab_source.Sources.file sources 0 in
    match Reader.parse sources file with
    | Error error -> Alcotest.fail (Read.show_errors [ error ])
    | Ok { taken; _ } ->
        let provenance =
          Provenance.make (Raylab_source.Sources.table sources)
        in
        List.map (Warning.to_string provenance) (Taken.warnings taken)
  in
  let taken word line =
    Printf.sprintf
      "'%s' is a name from here to the end of its block, and no longer the \
       word of the language (line %d)"
      word line
  in
  Alcotest.(check (list string))
    "each"
    [ taken "red" 2; taken "Depth" 3; taken "sphere" 4 ]
    (reading
       {|let red = 0.5 0 0
let f(Depth) = (Depth + 1)
for sphere = 1 to 2 end
let f2(red, own) = (red)|});
  Alcotest.(check (list string)) "none" [] (reading "let ball = 1")

let suite =
  ( "Provenance",
    objects
    @ [
        Alcotest.test_case "shared" `Quick test_sharing;
        Alcotest.test_case "data" `Quick test_data;
        Alcotest.test_case "an error far down" `Quick test_deep_error;
        Alcotest.test_case "a vast value" `Quick test_vast_value;
        Alcotest.test_case "taken words" `Quick test_taken;
      ] )
