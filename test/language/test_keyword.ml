open Raylab_language

let surfaces = [ "diffusive"; "reflective"; "luminous"; "mixed" ]

let check word ~among expected =
  Alcotest.(check (option string)) word expected (Keyword.nearest word ~among)

(* Beside each the changes that lead to the keyword: at most half as many as
   the word has letters. *)
let test_nearest () =
  check "difuse" ~among:surfaces (Some "diffusive") (* f, i, v: 3 of 6 *);
  check "mixd" ~among:surfaces (Some "mixed") (* e *);
  check "LUMINOS" ~among:surfaces (Some "luminous") (* u *);
  check "reflectiv" ~among:[ "reflective" ] (Some "reflective");
  check "imwith" ~among:[ "imHeight"; "imWidth" ] (Some "imWidth") (* d *);
  check "mirror" ~among:surfaces None;
  check "xyz" ~among:surfaces None;
  check "mixed" ~among:[] None;
  check (String.make 1_000_000 'm') ~among:surfaces None

let test_token () =
  let same a b = Alcotest.(check bool) a true (Keyword.token a = Some b) in
  same "sphere" SPHERE;
  same "SPHERE" SPHERE;
  same "bgcolor" BCOLOR;
  same "bcolor" BCOLOR;
  same "Red" (COLOR Raylab_scene.Color.red);
  Alcotest.(check bool) "no word" true (Keyword.token "spheres" = None);
  Alcotest.(check bool) "empty" true (Keyword.token "" = None);
  List.iter (fun (word, token) -> same word token) Keyword.all;
  (* 63 keywords, bgcolor among them, and 16 colours *)
  Alcotest.(check int) "all" 79 (List.length Keyword.all)

let suite =
  ( "Keyword",
    [
      Alcotest.test_case "nearest" `Quick test_nearest;
      Alcotest.test_case "token" `Quick test_token;
    ] )
