(* Expressions that are printed read back with the same parts. *)

open Raylab_source
open Raylab_expression
open Raylab_language
open Test_support

let parse text =
  let sources =
    Sources.make ~name:"test.scene" (Read.with_header ("let a = " ^ text))
  in
  match Reader.parse sources (List.hd (Sources.files sources)) with
  | Ok { included = { syntax = { header; _ }; _ }; _ } -> (
      match List.rev header with
      | Header_definition { value = Expression e; _ } :: _ -> e
      | _ -> Alcotest.failf "no expression: %s" text)
  | Error error ->
      Alcotest.failf "%s\nin: %s" (Property.show Scene_error.pp error) text

let nowhere = { Span.start = 0; stop = 0 }

(* The same without places. *)
let rec bare { Expression.desc; _ } =
  { Expression.desc = bare_desc desc; span = nowhere }

and bare_desc (desc : Expression.desc) : Expression.desc =
  match desc with
  | Number _ | Truth _ | Text _ | Name _ -> desc
  | Call { name; arguments; _ } ->
      let argument { Expression.label; value } =
        let label = Option.map (fun (label, _) -> (label, nowhere)) label in
        { Expression.label; value = bare value }
      in
      Call
        { name; name_span = nowhere; arguments = List.map argument arguments }
  | Triple (x, y, z) -> List [ bare x; bare y; bare z ]
  | List elements -> List (List.map bare elements)
  | Series { name; range; body; _ } ->
      let range : Expression.range =
        match range with
        | To { first; last; step } ->
            To
              {
                first = bare first;
                last = bare last;
                step = Option.map bare step;
              }
        | In e -> In (bare e)
      in
      Series { name; name_span = nowhere; range; body = bare body }
  | Part (e, letter) -> Part (bare e, letter)
  | Negative e -> Negative (bare e)
  | Not e -> Not (bare e)
  | Binary (operator, a, b) -> Binary (operator, bare a, bare b)
  | If (c, a, b) -> If (bare c, bare a, bare b)
  | Let { name; value; body; _ } ->
      Let { name; name_span = nowhere; value = bare value; body = bare body }
  | Word _ | Varying _ -> invalid_arg "a surface in an expression"

let printed e = Expression.to_string e

let reads_back text =
  let e = parse (Printf.sprintf "(%s)" text) in
  bare e = bare (parse (Printf.sprintf "(%s)" (printed e)))

let random =
  Property.holds "read, print, read" ~print:Fun.id ~count:1000
    (QCheck2.Gen.make_primitive ~gen:Random_program.number ~shrink:(fun _ ->
         Seq.empty))
    reads_back

(* What is written with the brackets that it needs is printed so. *)
let as_written =
  [
    "1 + 2 * 3"; "(1 + 2) * 3"; "1 - (2 - 3)"; "1 - 2 - 3"; "8 / (4 / 2)";
    "-2 ^ 2"; "(-2) ^ 2"; "2 ^ -1"; "2 ^ 3 ^ 2"; "(2 ^ 3) ^ 2"; "-(1 + 2)";
    "2 * -x"; "-a * b"; "-(a * b)"; "--1"; "not a and b"; "not (a and b)";
    "not not a"; "not a = b"; "(not a) = b"; "a or b and c"; "(a or b) and c";
    "(a = b) = c"; "a + b < c"; "if a then b else c + 1";
    "(if a then b else c) + 1"; "1 + (if a then b else c)";
    "if a then if b then c else d else e"; "let x = 1 in x + 1";
    "(let x = 1 in x) + 1"; "-(let x = 1 in x)"; "f(1, r: a + 1)"; "f()";
    "(a + b).x"; "a.x"; "f(1).y"; "[1, 2, 3].z"; "(-a).x"; "-a.x"; "a.x ^ 2";
    "[]"; "[a]"; "[[1, 2], 3]"; "[for i = 1 to 9: i * i]";
    "[for i = 0 to 1 by 0.1: i]"; "[for x in l: f(x)]"; "\"a # b\" = t"; "true";
    "0.1"; "1e+300"; "4.94066e-324"; "123456789.125";
  ]
[@@ocamlformat "disable"]

let test_as_written () =
  List.iter
    (fun text ->
      Alcotest.(check string)
        text text
        (printed (parse (Printf.sprintf "(%s)" text))))
    as_written

let test_fewer () =
  let check text expected =
    Alcotest.(check string) text expected (printed (parse text))
  in
  check "((1) + ((2)))" "1 + 2";
  check "((a * b) + (c ^ d))" "a * b + c ^ d";
  check "((f((1))))" "f(1)";
  check "1 (2 + 3) -4" "[1, 2 + 3, -4]";
  check "((if (a) then (b) else (c)))" "if a then b else c"

let suite =
  ( "Printed expressions",
    [
      Alcotest.test_case "as written" `Quick test_as_written;
      Alcotest.test_case "no more brackets than needed" `Quick test_fewer;
      random;
    ] )
