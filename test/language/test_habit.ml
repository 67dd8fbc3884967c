(* What those write who begin, or know other languages; what is said of it was
   written before it was said. *)

open Raylab_language

let last_line text = List.hd (List.rev (String.split_on_char '\n' text))

(* The message, and the last line of the advice. *)
let check text expected =
  Alcotest.test_case text `Quick (fun () ->
      let told { Scene_error.message; advice; _ } =
        message ^ " | " ^ last_line advice
      in
      Alcotest.(check string)
        text expected
        (told (List.hd (Read.errors (Read.with_header text)))))

let computed = "What is computed stands in brackets, such as "

let brackets =
  [
    check "let far = sqrt(4)"
      ("unknown value 'sqrt' | " ^ computed ^ "(sqrt(...)).");
    check "let far = -sqrt(4)"
      ("unknown value '-sqrt' | " ^ computed ^ "(-sqrt(...)).");
    check "let r = sin 30" ("unknown value 'sin' | " ^ computed ^ "(sin(...)).");
    check "let r = 2 + 1" ("unknown keyword '+' | " ^ computed ^ "(2 * 3 + 1).");
    check "let f(x) = x * 2"
      ("unknown shape '*' | " ^ computed ^ "(2 * 3 + 1).");
    check "sphere 0 0 2*3 1 reflective"
      ("'2*3' is not a number | " ^ computed ^ "(2 * 3 + 1).");
    check "let a = 1 sphere 0 0 6 -a reflective"
      ("'-a' is not a number | " ^ computed ^ "(2 * 3 + 1).");
    check "sphere 0 0 6 1 diffusive hsv(120, 1, 1)"
      ("unknown colour 'hsv' | " ^ computed ^ "[hsv(...)].");
    check "sphere 0 0 6 1 diffusive (hsv(120, 1, 1)) plane"
      "a number should stand here, not 'plane' | One that is computed stands \
       in [ ], such as [hsv(120, 1, 1)].";
    check "let p = [1, 2, 3] sphere p 1 reflective"
      "a number should stand here, not 'reflective' | One that has a name \
       stands in [ ].";
    check "let p = (1, 2, 3)"
      "an operator should stand here, not ',' | A point, a colour or a list \
       stands in [ ], such as [1, 2, 3].";
    check "let ball (x) = sphere x 0 6 1 reflective"
      "'=' should stand here, not '(' | A function has its bracket at once \
       behind its name: let ball(x) = ...";
    check "let ball(x) = sphere x 0 6 1 reflective ball (2)"
      "a shape should stand here, not '(' | A function has its bracket at \
       once behind its name: ball(2).";
  ]

let words =
  [
    check "let f(c) = sphere 0 0 6 1 diffusive c f(red)"
      "unknown name 'red' | in brackets write [1, 0, 0], or a name for it, as \
       in let paint = red";
    check "let c = (if time > 0 then gold else blue)"
      "unknown name 'gold' | in brackets write [1, 0.78, 0.3], or a name for \
       it, as in let paint = gold";
    check "let s = (reflective)"
      "unknown name 'reflective' | reflective does not stand in brackets: \
       give what it makes a name by let";
    check "let s = (sphere(0, 0, 6))"
      "unknown function 'sphere' | sphere does not stand in brackets: give \
       what it makes a name by let";
    check "sphere 0 0 6 1 diffusive rgb(1, 0, 0)"
      "unknown colour 'rgb' | A colour is three numbers, such as 1 0.5 0.";
    check "if (time > 0) then sphere 0 0 6 1 reflective end"
      "unknown item 'then' | The items follow the condition at once, as far \
       as end.";
    check "for i = 0 to 3 step 0.5 end"
      "unknown item 'step' | expected the first item of the loop, or by and a \
       step. Did you mean 'by'?";
    check "if (time > 0) endif"
      "unknown item 'endif' | expected the next item, else, or the end of the \
       if. Did you mean 'end'?";
  ]

let ends text suffix =
  Alcotest.test_case text `Quick (fun () ->
      match Read.errors (Read.with_header text) with
      | { advice; _ } :: _ ->
          Alcotest.(check string)
            text suffix
            (String.sub advice
               (String.length advice - String.length suffix)
               (String.length suffix))
      | [] -> Alcotest.fail "no error")

let signs =
  [
    ends "def f(x) = (x)" "Did you mean 'let'?";
    ends "repeat 5 end" "Did you mean 'for'?";
    check "let a = 1;"
      "unknown value '1;' | No semicolon stands between the parts of a scene.";
    check "sphere <0, 0, 6> 1 reflective"
      "'<0,' is not a number | A point or a colour is three numbers, with \
       nothing around.";
    check "include wood/oak.scene"
      "unknown file name 'wood/oak.scene' | expected the name of a file in \
       quotes after include, such as \"wood.scene\".";
    check "group { sphere 0 0 6 1 reflective }"
      "unknown item '{' | A block has no braces, and ends with the word end.";
    check "sphere 0 0 6 1 reflective // a ball"
      "unknown shape '//' | A comment starts with #, and ends with the line.";
    check "let x = 3 x = 4"
      "a shape should stand here, not '=' | A name keeps the value that it \
       has; let gives one to another name.";
    check "for i in 1 to 5 end"
      "a list should stand here, not '1' | To count, write = 1 to ...";
    check "let a = (time && true)"
      "'&&' is no operator | That both hold is written and.";
    check "let a = (3 % 2)"
      "'%' is no operator | The rest of a division is mod(a, b).";
    check "let a = (time > 0 ? 1 : 2)"
      "'?' is no operator | A choice is written if A then B else C.";
    check "let a = (l[0])"
      "an operator should stand here, not '[' | An element of a list is \
       nth(list, 0), counted from 0.";
  ]

let suite = ("Habits", brackets @ words @ signs)
