open Raylab_expression

(* How far a result may be from the exact one, by name: ... *)
let bounds =
  [
    ("sin", 0.9);
    ("cos", 0.9);
    ("tan", 0.9);
    ("asin", 0.52);
    ("acos", 0.52);
    ("atan", 0.52);
    ("atan2", 0.52);
    ("exp", 0.53);
    ("log", 0.51);
    ("pow", 0.53);
  ]

(* ... and how much farther where the smallest numbers have few digits. *)
let bound_at exact bound =
  if abs_float exact < min_float then bound +. 0.5 else bound

let result name arguments =
  match (name, arguments) with
  | "sin", [ x ] -> Degrees.sin x
  | "cos", [ x ] -> Degrees.cos x
  | "tan", [ x ] -> Degrees.tan x
  | "asin", [ x ] -> Arc.asin x
  | "acos", [ x ] -> Arc.acos x
  | "atan", [ x ] -> Arc.atan x
  | "atan2", [ y; x ] -> Arc.atan2 y x
  | "exp", [ x ] -> Power.exp x
  | "log", [ x ] -> Power.log x
  | "pow", [ x; y ] -> Power.pow x y
  | _ -> Alcotest.failf "no function %s" name

(* name, arguments, the exact result in two parts *)
let test_case name bound line =
  let numbers = List.tl (String.split_on_char ' ' line) in
  match List.rev_map float_of_string numbers with
  | low :: high :: arguments ->
      let x = result name (List.rev arguments) in
      let error = Ulp.error x ~high ~low in
      if not (error <= bound_at high bound) then
        Alcotest.failf "%s: %h is wrong by %.3f in the last place" line x error
  | _ -> Alcotest.failf "no case: %s" line

let test_function (name, bound) =
  let test () =
    let text = In_channel.with_open_text "cases.txt" In_channel.input_all in
    let cases =
      String.split_on_char '\n' text
      |> List.filter (String.starts_with ~prefix:(name ^ " "))
    in
    Alcotest.(check bool) "there are many" true (List.length cases > 60);
    List.iter (test_case name bound) cases
  in
  Alcotest.test_case name `Quick test

let suite = ("Cases", List.map test_function bounds)
