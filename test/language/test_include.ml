(* Scenes of several files, which here are in memory. *)

open Raylab_source
open Raylab_scene
open Raylab_language
open Test_support

let access ?(counts = Hashtbl.create 1) files =
  let find ~from name =
    let path = Access.join ~from name in
    if List.mem_assoc path files then Ok { Access.path; identity = path }
    else Access.refuse "no such file"
  and read ~limit:_ { Access.path; _ } =
    Hashtbl.add counts path ();
    Ok (List.assoc path files)
  in
  { Access.main = Some "main.scene"; find; read }

let parse ?counts files =
  let text = List.assoc "main.scene" files in
  Scene_file.parse ~access:(access ?counts files)
    (Sources.make ~name:"main.scene" text)

let scene files =
  match parse files with
  | Ok scene -> scene
  | Error errors -> Alcotest.fail (Read.show_errors errors)

let main = Read.with_header

(* What several files say is what one says. *)
let check_same what one files =
  Alcotest.check Same.scene what (Read.scene one) (scene files)

let check_error what expected files =
  match parse files with
  | Ok _ -> Alcotest.failf "%s: no error" what
  | Error errors ->
      Alcotest.(check string) what expected (Read.show_errors errors)

let ball x = Printf.sprintf "sphere %d 0 6 1 reflective\n" x

let test_place () =
  check_same "in the header, its items come first"
    (main (ball 1 ^ ball 2 ^ ball 3))
    [
      ("main.scene", {|include "a"|} ^ "\n" ^ main (ball 2 ^ ball 3));
      ("a", ball 1);
    ];
  check_same "among items, they stand there"
    (main (ball 1 ^ ball 2 ^ ball 3))
    [
      ("main.scene", main (ball 1 ^ {|include "a"|} ^ "\n" ^ ball 3));
      ("a", ball 2);
    ];
  check_same "in blocks, each time"
    (main
       ("for i = 1 to 2 " ^ ball 1 ^ " end group " ^ ball 1
      ^ "end translated 1 0 0"))
    [
      ( "main.scene",
        main
          {|for i = 1 to 2 include "a" end
            group if (1 < 2) include "a" else include "b" end end
              translated 1 0 0|}
      );
      ("a", ball 1);
      ("b", ball 2);
    ];
  check_same "relative to the file that names them"
    (main (ball 1 ^ ball 2))
    [
      ("main.scene", main {|include "x/a"|});
      ("x/a", ball 1 ^ {|include "y/b"|});
      ("x/y/b", ball 2);
    ]

let test_settings () =
  check_same "in the header they count" (main "raydepth 7")
    [
      ("main.scene", {|include "a" raydepth 7|});
      ("a", {|include "b"|});
      ("b", main "");
    ];
  check_same "twice is once" (main "")
    [ ("main.scene", {|include "a" include "a"|}); ("a", main "") ];
  check_same "elsewhere they do not"
    (main (ball 1 ^ ball 2))
    [
      ("main.scene", main (ball 1 ^ {|include "a"|}));
      ("a", "imWidth 7 raydepth 3 raydepth (foo(2)) " ^ ball 2);
    ];
  check_error "two of them"
    {|main.scene:2:1-8: error: raydepth is set a second time
    2 | raydepth 3 imWidth 4 imHeight 3 canvWidth 8 canvHeight 6 depth 5
      | ^^^^^^^^
it is already set in line 2 of a; remove one of them|}
    [
      ("main.scene", {|include "a"|} ^ "\n" ^ "raydepth 3 " ^ main "");
      ("a", "\nraydepth 3");
    ]

let test_names () =
  let files rest =
    [
      ("main.scene", main ({|include "a" include "b" |} ^ rest));
      ("a", {|include "c" let two = (one + 1)|});
      ("b", {|include "c" let three(x) = (one + x)|});
      ("c", "let one = 1 let glass = reflective");
    ]
  in
  check_same "all of them are known, and those of a third file once"
    (main (ball 1 ^ ball 2 ^ ball 3))
    (files
       {|sphere one 0 6 1 glass sphere two 0 6 1 glass
         sphere three(2) 0 6 1 glass|});
  check_error "a file knows no others"
    {|a:1:8-10: error: 'one' is not a number
    1 | sphere one 0 0 1 reflective
      |        ^^^
expected the centre of the sphere: sphere CENTRE RADIUS, the centre being
three numbers, x y z.|}
    [
      ("main.scene", main {|let one = 1 include "a"|});
      ("a", "sphere one 0 0 1 reflective");
    ];
  check_error "they end with the block"
    {|main.scene:2:32-34: error: 'one' is not a number
    2 |   group include "a" end sphere one 0 0 1 reflective
      |                                ^^^
expected the centre of the sphere: sphere CENTRE RADIUS, the centre being
three numbers, x y z.|}
    [
      ( "main.scene",
        main {|  group include "a" end sphere one 0 0 1 reflective|} );
      ("a", "let one = 1");
    ];
  check_error "two definitions"
    {|main.scene:2:21-23: error: one is defined a second time, in line 2 of b
    2 | include "a" include "b"
      |                     ^^^
it is already defined in line 1 of a; what is included must not define the same names
main.scene:3:5-7: error: one is defined a second time
    3 | let one = 3
      |     ^^^
it is already defined in line 1 of a; choose another name|}
    [
      ("main.scene", main {|include "a" include "b"|} ^ "\nlet one = 3");
      ("a", "let one = 1");
      ("b", "\nlet one = 2");
    ]

(* A function that includes a file, which defines names in the outermost
   frame. *)
let test_function () =
  check_same "from a function"
    (main (ball 2 ^ ball 2))
    [
      ( "main.scene",
        main
          {|let f(n) = group let k = n include "a" end
            f(1) f(5)|}
      );
      ("a", "let k2 = (random(1) * 0 + 2) sphere k2 0 6 1 reflective");
    ]

let test_faults () =
  check_error "a number in it"
    {|a:2:15-16: error: the radius must be greater than 0, not -1
    2 | sphere 0 0 6  -1 reflective
      |               ^^
with i = 1, line 2|}
    [
      ("main.scene", main {|for i = 1 to 3 include "a" end|});
      ("a", "\nsphere 0 0 6  -1 reflective");
    ];
  check_error "its syntax, and a file that lacks"
    {|a:1:8-10: error: 'foo' is not a number
    1 | sphere foo
      |        ^^^
expected the centre of the sphere: sphere CENTRE RADIUS, the centre being
three numbers, x y z.
main.scene:2:21-23: error: 'b' cannot be included: no such file
    2 | include "a" include "b" foo
      |                     ^^^|}
    [
      ("main.scene", main {|include "a" include "b" foo|}); ("a", "sphere foo");
    ]

let test_circle () =
  check_error "a circle"
    {|b:1:9-20: error: files include each other in a circle
    1 | include "main.scene"
      |         ^^^^^^^^^^^^
main.scene includes "a" in line 1,
a includes "b" in line 2,
b includes "main.scene" in line 1|}
    [
      ("main.scene", {|include "a"|});
      ("a", "\ninclude \"b\"");
      ("b", {|include "main.scene"|});
    ]

let chain deepest =
  let link k = (string_of_int k, Printf.sprintf {|include "%d"|} (k + 1)) in
  ("main.scene", main {|include "1"|})
  :: (string_of_int deepest, ball 1)
  :: List.init (deepest - 1) (fun k -> link (k + 1))

let test_deep () =
  check_same "100 deep" (main (ball 1)) (chain 100);
  check_error "101 deep"
    {|100:1:9-13: error: files are included deeper than 100
    1 | include "101"
      |         ^^^^^|}
    (chain 101)

(* 2^40 places of a file that is read once. *)
let test_doubling () =
  let link k =
    let next = Printf.sprintf {|include "%d" |} (k + 1) in
    (string_of_int k, next ^ next)
  in
  let files =
    ("main.scene", main {|include "1"|})
    :: ("41", ball 1)
    :: List.init 40 (fun k -> link (k + 1))
  in
  let counts = Hashtbl.create 50 in
  (match parse ~counts files with
  | Error [ { message; _ } ] -> Expect.contains "it ends" ~part:"than" message
  | _ -> Alcotest.fail "2^40 spheres");
  Alcotest.(check int) "read once" 41 (Hashtbl.length counts)

let check_origin what expected text =
  let ({ Scene.objects; _ } as scene) =
    scene [ ("main.scene", main text); ("a", "\n" ^ ball 1) ]
  in
  let place (o : Object.t) =
    Option.map Provenance.to_string (Scene.provenance scene o.origin)
  in
  Alcotest.(check (list (option string)))
    what [ Some expected ] (List.map place objects)

let test_origin () =
  check_origin "the file is named" "line 2 of a" {|include "a"|};
  check_origin "and the round in which it stands" "line 2 of a, i = 3, line 2"
    {|for i = 3 to 3 include "a" end|}

let suite =
  ( "Include",
    [
      Alcotest.test_case "where things stand" `Quick test_place;
      Alcotest.test_case "settings" `Quick test_settings;
      Alcotest.test_case "names" `Quick test_names;
      Alcotest.test_case "in a function" `Quick test_function;
      Alcotest.test_case "errors" `Quick test_faults;
      Alcotest.test_case "a circle" `Quick test_circle;
      Alcotest.test_case "depth" `Quick test_deep;
      Alcotest.test_case "doubling" `Quick test_doubling;
      Alcotest.test_case "origins" `Quick test_origin;
    ] )
