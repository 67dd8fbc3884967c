(* Patterns keep what the names in them are, however the text around calls other
   things so. *)

open Raylab_scene
open Raylab_language
open Test_support
open Build

let printed scene = Format.asprintf "%a" Scene_file.print scene

(* The surface of the last object of [text], which is the same in the scene that
   is printed, and in one that was marshalled. *)
let surface what text =
  let scene = Read.scene (Read.with_header text) in
  Alcotest.check Same.scene (what ^ ", printed") scene
    (Read.scene (printed scene));
  let copy : Scene.t = Marshal.from_string (Marshal.to_string scene []) 0 in
  Alcotest.check Same.scene (what ^ ", marshalled") scene copy;
  let last = List.hd (List.rev copy.objects) in
  last.surface

let check what text expected =
  Alcotest.check Same.surface what expected
    (Surface.at (surface what text) (v 3. 4. 5.))

let matt r g b = Surface.diffusive (rgb r g b)

(* No coordinate of it is negative. *)
let ball = "sphere 9 9 9 1 "
let middle = "sphere 0 0 0 1 "

let test_values () =
  check "the point" (ball ^ "varying p diffusive [p]") (matt 3. 4. 5.);
  check "a number, a vector and a text"
    ("let k = 2 let v = [1, 2, 3] let t = \"a\" " ^ ball
   ^ "varying p diffusive [k, v.y, if t = \"a\" then 1 else 0]")
    (matt 2. 2. 1.);
  check "a truth value and lists"
    ("let is = (true) let l = [[7], 8, [9, 9, 9], []] " ^ ball
   ^ "varying p diffusive [if is then 1 else 0, nth(l, 1), count(l)]")
    (matt 1. 8. 4.);
  check "the time" (ball ^ "varying p diffusive [time, 1, 2]") (matt 0. 1. 2.);
  check "a value of a round"
    ("for i = 1 to 3 " ^ ball ^ "varying p diffusive [i, 0, 0] end")
    (matt 3. 0. 0.);
  check "an argument"
    ("let thing(k, s: 4) = group " ^ ball
   ^ "varying p diffusive [k, s, 0] end thing(7)")
    (matt 7. 4. 0.)

let test_functions () =
  check "a function that sees what it saw"
    ("let k = 2 let f(p) = (k * p.x) if (true) let k = 10 " ^ ball
   ^ "varying p diffusive [f(p), k, 0] end")
    (matt 6. 10. 0.);
  check "one that calls itself"
    ("let f(n) = (if n < 1 then 0 else n + f(n - 1)) " ^ ball
   ^ "varying p diffusive [f(p.y), 0, 0]")
    (matt 10. 0. 0.);
  check "functions as values"
    ("let twice(f, x) = (f(f(x))) let half(x, part: 2) = (x / part) let l1 = \
      (half) " ^ ball
   ^ "varying p diffusive [twice(half, p.y), twice(sqrt, 16), l1(8)]")
    (matt 1. 2. 4.)

let test_surfaces () =
  check "a function that makes it"
    ("let wood(p, c: [1, 0, 0]) = mixed (p.x) diffusive [c] 0.5 reflective "
   ^ ball ^ "varying p wood(p)")
    (Surface.mixed [ (3., matt 1. 0. 0.); (0.5, Surface.reflective) ]);
  check "named ones, of which one varies"
    ("let k = 2 let a = varying q diffusive [q.z, k, 0] let b = reflective "
   ^ ball ^ "varying k (if k.x > 0 then a else b)")
    (matt 5. 2. 0.);
  check "in a list"
    ("let l = [for i = 0 to 3: i] let a = luminous red let b = reflective "
   ^ "let s = [a, b] " ^ ball ^ "varying p (nth(s, nth(l, 1)))")
    Surface.reflective;
  check "in one of another point"
    (ball ^ "varying p checker (p.x) varying q diffusive [q] reflective")
    Surface.reflective;
  check "two that call different things so"
    ("let k = 1 let a = varying p diffusive [k, 0, 0] if (true) let k = 2 let \
      b = varying p diffusive [k, 0, 0] " ^ ball ^ "checker 100 a b end")
    (matt 1. 0. 0.);
  check "a weight after it"
    ("let a = varying p mixed 1 diffusive [p] " ^ ball
   ^ "mixed 2 a 3 reflective")
    (Surface.mixed [ (2., matt 3. 4. 5.); (3., Surface.reflective) ])

(* What is printed takes over no word. *)
let test_words () =
  check "names that are words"
    ("let sphere = 3 let let_ = 1 let noise(x) = (x) let white = [1, 2, 3] "
   ^ "plane 0 0 6 0 0 1 "
   ^ "varying rotated diffusive [sphere, noise(2), abs(rotated.x) + white.y] "
   ^ "translated 0 0 1")
    (matt 3. 2. 5.)

let sky text =
  let scene = Read.scene (Read.with_header text) in
  Alcotest.check Same.scene "printed" scene (Read.scene (printed scene));
  Background.at scene.background (v 0. 1. 0.)

let test_sky () =
  Alcotest.check Same.color "of the direction" (rgb 2. 1. 0.)
    (sky "let k = 2 let f(d) = (abs(d.y)) bcolor varying d [k, f(d), 0]");
  Alcotest.check Same.color "a word" (rgb 1. 1. 1.)
    (sky "let c = white bcolor varying d c")

let messages text =
  List.map
    (fun e -> e.Scene_error.message)
    (Read.errors (Read.with_header text))

let check_error what text expected =
  Alcotest.(check (list string)) what [ expected ] (messages text)

let test_errors () =
  check_error "an unknown name"
    (ball ^ "varying p diffusive [p.x, kk, 0]")
    "unknown name 'kk'";
  check_error "one that is known only in it"
    (ball ^ "varying p diffusive [p * p] plane 0 0 9 0 0 1 diffusive p")
    "unknown name 'p'";
  check_error "an object"
    ("let o = " ^ ball ^ "reflective " ^ ball
   ^ "varying p (if p.x > 0 then o else o)")
    "an object cannot be used in a pattern";
  check_error "a function that makes objects"
    ("let o(p) = " ^ ball ^ "reflective " ^ ball ^ "varying p o(p)")
    "o, which makes objects, cannot be used in a pattern";
  check_error "a negative colour"
    (middle ^ "varying p diffusive [p.x, 1, 1]")
    "the red of the surface's colour must not be negative, not p.x, which is \
     -0.740359";
  check_error "no surface"
    (middle ^ "varying p (p.x)")
    "a surface should stand here, and p.x is a number, -0.740359";
  check_error "too many steps"
    ("let f(n) = (count([for i = 1 to n: i])) " ^ ball
   ^ "varying p diffusive [f(100000), 1, 1]")
    "the evaluation takes more than 100,000 steps";
  check_error "a sky" "bcolor varying d [d.y, 0, 0]"
    "the red of the background must not be negative, not d.y, which is \
     -0.18701"

let suite =
  ( "Patterns",
    [
      Alcotest.test_case "values" `Quick test_values;
      Alcotest.test_case "functions" `Quick test_functions;
      Alcotest.test_case "surfaces" `Quick test_surfaces;
      Alcotest.test_case "names that are words" `Quick test_words;
      Alcotest.test_case "the sky" `Quick test_sky;
      Alcotest.test_case "errors" `Quick test_errors;
    ] )
