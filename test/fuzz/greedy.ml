let many n text = String.concat "" (List.init n (fun _ -> text))

let of_scenes =
  let header = "imWidth 4 imHeight 3 canvWidth 8 canvHeight 6 depth 5\n" in
  List.map (fun (name, text) -> (name, header ^ text))

let ball = " sphere 0 0 6 1 reflective "

let texts =
  of_scenes
    [
      ("a loop", "for i = 1 to 1e15 end");
      ("a list", "let l = [for i = 1 to 1e9: i]");
      ("calls without end", "let f(n) = (f(n + 1)) let a = f(0)");
      ("groups without end", "let f(n) = group f(n + 1) end f(0)");
      ("objects that double",
       "let f(n) = group if (n < 1)" ^ ball
       ^ "else let x = f(n - 1) x x end end f(99)");
      ("empty groups that double",
       "let f(n) = group if (n > 0) let x = f(n - 1) x x end end f(999)");
      ("brackets", "let a = " ^ many 5000 "(" ^ "1" ^ many 5000 ")");
      ("open brackets", "let a = " ^ many 100_000 "(");
      ("open lists", "let a = " ^ many 100_000 "[");
      ("open groups", many 100_000 "group ");
      ("open loops", many 100_000 "for i = 1 to 2 ");
      ("open conditions", many 100_000 "if (true) ");
      ("else without end", "if (true) " ^ many 100_000 "else if (true) ");
      ("a sum of many", "let a = (1" ^ many 100_000 " + 1" ^ ")");
      ("signs", "let a = (" ^ many 100_000 "-" ^ "1)");
      ("an open text", "let a = \"" ^ many 100_000 "a");
      ("an open parameter list", "let f(" ^ many 100_000 "a, ");
      ("names that are words",
       "let sphere = 1 let plane = 2 let group = 3 sphere 0 0 6 1 reflective");
      ("numbers that grow",
       "let f(x, n) = (if n < 1 then x else f(x * x, n - 1)) let a = f(2, 99)");
    ]
[@@ocamlformat "disable"]

let slow =
  of_scenes
    [
      ("a loop of a tiny step", "for i = 0 to 1 by 1e-300" ^ ball ^ "end");
      ("loops in loops", many 9 "for i = 1 to 1e3 " ^ ball ^ many 9 "end ");
      ("objects", "for i = 1 to 1e9" ^ ball ^ "end");
      ("lists in a list",
       "let l = [for i = 1 to 1e5: [for j = 1 to 1e5: [i, j]]]");
      ("calls that double",
       "let f(n) = (if n < 1 then 1 else f(n - 1) + f(n - 1)) let a = f(99)");
      ("a deep group, often",
       "let f(n) = group if (n < 1)" ^ ball
       ^ "else let x = f(n - 1) x translated 1 0 0 end end let deep = f(900) \
          for i = 1 to 1e7 deep end");
      ("lists that double, compared",
       "let f(l, n) = (if n < 1 then l else f([l, l], n - 1)) let a = (f([1], \
        99) = f([1], 99))");
    ]
[@@ocamlformat "disable"]
