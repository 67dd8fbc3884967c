(* Scenes that are programs, and the same scenes written out by hand. *)

open Test_support

let same name program plain =
  Alcotest.test_case name `Quick (fun () ->
      Alcotest.check Same.scene name
        (Read.scene (Read.with_header plain))
        (Read.scene (Read.with_header program)))

(* What an expression has is the radius of a sphere. *)
let value text expected =
  Alcotest.test_case text `Quick (fun () ->
      let program =
        Printf.sprintf "sphere 0 0 6 (%s) reflective" text
        |> Read.with_header |> Read.scene
      in
      match program.objects with
      | [ { shape = Sphere { radius; _ }; _ } ] ->
          Alcotest.(check (float 0.)) text expected radius
      | _ -> Alcotest.fail "no sphere")

let values =
  [
    value "1 + 2 * 3" 7.;
    value "(1 + 2) * 3" 9.;
    value "5 - 2 - 1" 2.;
    value "8 / 4 / 2" 1.;
    value "10 + -2^2" 6.;
    value "2^3^2" 512.;
    value "2^-1" 0.5;
    value "if 1 < 2 and not (2 <= 1) then 3 else 4" 3.;
    value "if true or 1 / 0 > 1 then 3 else 4" 3.;
    value "if not 1 = 2 then 3 else 4" 3.;
    value "let x = 2 in let y = x + 1 in x * y" 6.;
    value "[1, 2, 3].y" 2.;
    value "([1, 2, 3] + 2 * [1, 1, 1]).z" 5.;
    value "([1, 2, 3] * [2, 3, 4]).g" 6.;
    value "nth([4, 5], 1)" 5.;
    value "count([for i = 0 to 1 by 0.1: i])" 11.;
    value "count([for i = 1 to 0: i]) + 1" 1.;
    value "nth([for v in [1, 2, 4]: v * v], 2)" 16.;
    value "mod(-1, 3)" 2.;
    value "sin(30)" 0.5;
    value "cos(90) + 1" 1.;
    value "length([3, 4, 0])" 5.;
    value "mix(1, 3, 0.25)" 1.5;
    value "max(time, 1)" 1.;
    value "if [1, 2] = [1, 2] then 1 else 2" 1.;
    value "if \"a\" <> \"b\" then 1 else 2" 1.;
    value "MAX(B: 3, a: 2)" 3.;
  ]

let scenes =
  [
    same "numbers" "let r = 2 sphere 0 0 6 r reflective"
      "sphere 0 0 6 2 reflective";
    same "vectors" "let p = 0 (1 + 1) 6 sphere [p] 1 reflective"
      "sphere 0 2 6 1 reflective";
    same "a light that does not fade"
      "let lamp = spherical 1 white 0 2 0 lamp unfading translated 1 0 0"
      "spherical 1 white 1 2 0 unfading";
    same "all lights of a group"
      "group spherical 1 white 0 2 0 group spot 1 white 0 2 0 0 0 (1 + 1) 5 9 \
       end sphere 0 0 6 1 reflective end unfading"
      "spherical 1 white 0 2 0 unfading spot 1 white 0 2 0 0 0 2 5 9 unfading \
       sphere 0 0 6 1 reflective";
    same "lights that are moved"
      "area 1 white 0 2 0 1 0 0 0 0 3 4 scaled 2 rotated 0 1 0 90 translated \
       0 1 0 spot 1 white 1 2 0 1 0 0 5 9 stretched 3 1 1"
      "area 1 white 0 5 0 0 0 -2 6 0 0 4 spot 1 white 3 2 0 3 0 0 5 9";
    same "ambient light" "let dim = [0.1, 0.2, 0.3] sphere 0 0 6 1 reflective"
      "sphere 0 0 6 1 reflective";
    same "colours" "let sand = [1, 0.5, 0] sphere 0 0 6 1 diffusive sand"
      "sphere 0 0 6 1 diffusive 1 0.5 0";
    same "surfaces"
      "let brass = mixed 0.5 diffusive gold 0.5 reflective sphere 0 0 6 1 \
       brass"
      "sphere 0 0 6 1 mixed 0.5 diffusive 1 0.78 0.3 0.5 reflective";
    same "a chosen surface"
      "let matt = diffusive red let mirror = reflective for i = 0 to 1 sphere \
       i 0 6 1 (if i = 0 then matt else mirror) end"
      "sphere 0 0 6 1 diffusive red sphere 1 0 6 1 reflective";
    same "functions and defaults"
      "let ball(z, r: z / 2) = sphere 0 0 z r reflective ball(6) ball(r: 1, \
       z: 4)"
      "sphere 0 0 6 3 reflective sphere 0 0 4 1 reflective";
    same "loops" "for i = 0 to 1 by 0.5 sphere i 0 6 1 reflective end"
      "sphere 0 0 6 1 reflective sphere 0.5 0 6 1 reflective sphere 1 0 6 1 \
       reflective";
    same "loops over lists"
      "for p in [[0, 1, 6], [1, 2, 7]] sphere [p] 1 reflective end"
      "sphere 0 1 6 1 reflective sphere 1 2 7 1 reflective";
    same "conditions"
      "for i = 0 to 2 if (i = 0) sphere 0 0 6 1 reflective else if (i = 1) \
       sphere 0 0 7 1 reflective else sphere 0 0 8 1 reflective end end"
      "sphere 0 0 6 1 reflective sphere 0 0 7 1 reflective sphere 0 0 8 1 \
       reflective";
    same "groups and modifiers"
      "group sphere 1 0 0 1 reflective spherical 2 red 0 1 0 end scaled 2 \
       translated 0 0 6"
      "lights spherical 2 red 0 2 6 sphere 2 0 6 2 reflective";
    same "the left-hand rule" "sphere 0 0 6 1 reflective rotated 0 1 0 90"
      "sphere 6 0 0 1 reflective";
    same "planes and lights turn"
      "directional 1 white 0 0 1 rotated 0 1 0 90 plane 0 0 6 0 0 -1 \
       reflective rotated 0 1 0 90 translated 1 0 0"
      "lights directional 1 white 1 0 0 plane 7 0 0 -1 0 0 reflective";
    same "an object by its name"
      "let ball = sphere 0 0 6 1 reflective ball ball translated 1 0 0"
      "sphere 0 0 6 1 reflective sphere 1 0 6 1 reflective";
    same "recursion"
      "let tower(n) = group sphere 0 n 6 0.5 reflective if (n > 0) tower(n - \
       1) end end tower(2)"
      "sphere 0 2 6 0.5 reflective sphere 0 1 6 0.5 reflective sphere 0 0 6 \
       0.5 reflective";
    same "a function as an argument"
      "let twice(f, x) = (f(f(x))) let half(x) = (x / 2) sphere 0 0 6 \
       (twice(half, 8)) reflective"
      "sphere 0 0 6 2 reflective";
    same "a name wins over a word"
      "let red = 0 0 1 sphere 0 0 6 1 diffusive red"
      "sphere 0 0 6 1 diffusive blue";
    same "until the end of its block"
      "group let red = 0 0 1 sphere 0 0 6 1 diffusive red end sphere 0 0 6 1 \
       diffusive red"
      "sphere 0 0 6 1 diffusive blue sphere 0 0 6 1 diffusive red";
    same "a shadow in a block"
      "let r = 1 group let r = 2 sphere 0 0 6 r reflective end sphere 0 0 6 r \
       reflective"
      "sphere 0 0 6 2 reflective sphere 0 0 6 1 reflective";
    same "a block of a solid is one, too"
      "group let red = 0 0 1 union let red = 0 1 0 sphere 0 0 6 1 diffusive \
       red end sphere 0 0 9 1 diffusive red end sphere 0 0 9 2 diffusive red"
      "union sphere 0 0 6 1 diffusive green end sphere 0 0 9 1 diffusive blue \
       sphere 0 0 9 2 diffusive red";
    same "lights among objects"
      "sphere 0 0 6 1 reflective spherical 1 red 0 0 0"
      "lights spherical 1 red 0 0 0 objects sphere 0 0 6 1 reflective";
  ]

let suite = ("Programs", values @ scenes)
