type t = { noun : string; advice : string }

let expected noun what =
  let stop = if String.ends_with ~suffix:"." what then "" else "." in
  Some { noun; advice = "expected " ^ what ^ stop }

(* {1 After a word} *)

let after_word (keyword : Keyword.t) count =
  match List.nth_opt keyword.parameters count with
  | Some { noun; expected = what } -> expected noun what
  | None -> None

(* {1 Anything else} *)

let expression = "a number, a name, a function or what stands in brackets"
let range = "= and the first value, or in and a list, after the name of a loop"

(* All words of a role, in lines of some fifty letters. *)
let words role =
  let add (text, width) word =
    let separator, width = if width > 40 then ("\n", 0) else (" ", width) in
    (text ^ separator ^ word, width + String.length word + 1)
  in
  let rec punctuated = function
    | [ last_but_one; last ] -> [ last_but_one; "or"; last ]
    | word :: (_ :: _ as rest) -> (word ^ ",") :: punctuated rest
    | ([] | [ _ ]) as few -> few
  in
  match punctuated (Keyword.words role) with
  | first :: rest -> fst (List.fold_left add (first, String.length first) rest)
  | [] -> ""

let shapes = words Shape
let surfaces = words Surface
let next_item = "a shape: " ^ shapes ^ ". Settings stand before the objects"

let vector letter =
  Printf.sprintf
    "the %s of a point or vector, which is three numbers: x y z.\n\
     One that has a name stands in [ ]"
    letter

let channel name =
  Printf.sprintf
    "the %s of a colour: a colour is three numbers, red green blue.\n\
     One that is computed stands in [ ], such as [hsv(120, 1, 1)]"
    name

let value =
  "the value after =: a number, a colour, what stands in brackets, a surface, \
   a light\n\
   or an object"

let item_or_end opened =
  Printf.sprintf "the next item, or the end of the %s" opened

(* What follows what has been read of a production. *)
let rule whole before after =
  match (whole, before, after) with
  | ("scene" | "scene'"), _, _ ->
      expected "keyword"
        ("a setting of the header (imWidth, imHeight, canvWidth, canvHeight,\n\
          depth, eye, lookAt, up, fov, bcolor, ambient, raydepth), or lights, \
          objects, or\n\
          a shape: "
        ^ shapes)
  | "body", [ "LIGHTS"; _ ], _ | "simple_thing", [ "light" ], _ ->
      expected "light"
        ("a light (directional, spherical, spot or area), or the objects of the\n\
          scene: objects, " ^ shapes
        ^ ". Settings stand before the lights")
  | "vector", [ _ ], _ -> expected "number" (vector "y")
  | "vector", _, _ -> expected "number" (vector "z")
  | "color", [ _ ], _ -> expected "number" (channel "green")
  | "color", _, _ -> expected "number" (channel "blue")
  | "value", [ "plain" ], _ ->
      expected "keyword"
        "what follows the definition, or two more numbers for a vector"
  | "value", _, "plain" :: _ -> expected "number" (vector "z")
  | "parts", [ "weight" ], _ ->
      expected "surface"
        ("a surface after its weight:\n" ^ surfaces)
  | "parts", _, _ ->
      expected "shape"
        ("the next object (" ^ shapes
        ^ "), or another weight and surface for the mix")
  | _, _, "surface" :: _ -> expected "surface" ("a surface: " ^ surfaces)
  | "group", _, _ -> expected "item" (item_or_end "grouping")
  | "simple_thing", "FOR" :: _, "range" :: _ -> expected "'=' or 'in'" range
  | "simple_thing", "FOR" :: _, _ -> expected "item" (item_or_end "loop")
  | ("thing" | "otherwise"), _, "condition" :: _ | "condition", _, _ ->
      expected "condition"
        "a condition in brackets after if, such as (n > 0)"
  | ("thing" | "otherwise"), _, "otherwise" :: _ ->
      expected "item" "the next item, else, or the end of the if"
  | "otherwise", _, _ | ("else_items" | "some_else_items"), _, _ ->
      expected "item" (item_or_end "if")
  | "separated_nonempty_list_COMMA_argument_", [ _ ], _ ->
      expected "operator" "an operator, a comma, or ) to end the arguments"
  | _, _, "items" :: _ | ("items" | "things"), _, _ ->
      expected "shape" next_item
  | _, _, ("modifiers" | "some_modifiers") :: _
  | ("modifiers" | "some_modifiers"), _, _ ->
      expected "shape"
        ("the next object (" ^ shapes
        ^ "), or scaled, stretched, rotated,\n\
           translated, shadowless or unfading for the one before. Settings \
           stand before\nthe objects")
  | "definition", [ "LET" ], _ ->
      expected "name"
        "a name after let: letters, digits and _, and none of let, for, if, \
         else,\nend, to, by, in and include"
  | "definition", _, "EQUAL" :: _ ->
      expected "'='" "= and a value after the name in a definition"
  | "definition", _, "value" :: _ -> expected "value" value
  | "definition", _, _
  | ( ("parameter" | "separated_nonempty_list_COMMA_parameter_"),
      _,
      ( []
      | ( "separated_nonempty_list_COMMA_parameter_"
        | "loption_separated_nonempty_list_COMMA_parameter__" )
        :: _ ) ) ->
      expected "parameter"
        "names of parameters, with commas between them: let f(a, b: 1) = ..."
  | "parameter", [ _ ], _ ->
      expected "',' or ')'"
        "a comma, a colon and a default, or ) after a parameter"
  | "range", [ "IN" ], _ -> expected "list" "a list after in: [ ... ] or a name"
  | "range", [ "EQUAL" ], _ ->
      expected "number" "the first value of the loop after ="
  | "range", _, "TO" :: _ | "expr_range", _, "TO" :: _ ->
      expected "'to'" "to and the last value of the loop"
  | "range", _, "BY" :: _ ->
      expected "item" "the first item of the loop, or by and a step"
  | "range", _, _ ->
      expected "number" "a number of the loop: = FIRST to LAST by STEP"
  | "bracketed", [ "LBRACKET" ], _ ->
      expected "value" "the parts of a vector, the elements of a list, or for"
  | "bracketed", [ "LBRACKET"; "FOR" ], _ ->
      expected "name" "the name of the loop after for"
  | "bracketed", _, "COLON" :: _ ->
      expected "operator" "an operator, or : and what each round gives"
  | "bracketed", _, "RBRACKET" :: _ ->
      expected "operator" "an operator, or ] to close the list"
  | "expr_range", _, "BY" :: _ ->
      expected "operator"
        "an operator, by and a step, or : and what each round gives"
  | "bracketed", _, "expr_range" :: _ -> expected "'=' or 'in'" range
  | "expr", [ "LET" ], _ -> expected "name" "a name after let"
  | "expr", [ "LET"; _ ], _ -> expected "'='" "= and a value after the name"
  | "expr", "LET" :: _, "IN" :: _ ->
      expected "'in'" "in, and the expression in which the name is known"
  | "expr", "IF" :: _, "THEN" :: _ ->
      expected "'then'" "then after the condition: if A then B else C"
  | "expr", "IF" :: _, "ELSE" :: _ ->
      expected "'else'" "else, and the other value: if A then B else C"
  | "argument", [ _; _ ], _ -> expected "value" expression
  | _, _, "expr" :: _
  | _, _, "separated_nonempty_list_COMMA_expr_" :: _
  | _, _, "loption_separated_nonempty_list_COMMA_argument__" :: _
  | _, _, "separated_nonempty_list_COMMA_argument_" :: _ ->
      expected "value" expression
  | _, _, "RPAREN" :: _ ->
      expected "operator" "an operator, or ) to close the bracket"
  | "separated_nonempty_list_COMMA_expr_", _, _ ->
      expected "operator" "an operator, a comma, or ] to close the list"
  | ("expr" | "expr_range" | "argument" | "reference"), _, _ ->
      expected "operator"
        "an operator, or what closes the bracket"
  | _ -> None
[@@ocamlformat "disable"]

let of_item { Parser_state.whole; before; after } =
  match (whole, before) with
  | "setting", [ "BCOLOR"; "VARYING" ] ->
      expected "name"
        "a name for the direction after bcolor varying:\n\
         bcolor varying NAME COLOUR"
  | "setting", [ "BCOLOR"; "VARYING"; _ ] ->
      expected "colour"
        "the colour after the name of the direction: bcolor varying NAME \
         COLOUR"
  | ( ("light" | "shape" | "setting" | "own_surface" | "modifier" | "inclusion"),
      word :: rest ) ->
      Option.bind (Keyword.of_symbol word) (fun keyword ->
          after_word keyword (List.length rest))
  | "simple_thing", [ "FOR" ] ->
      Option.bind (Keyword.of_symbol "FOR") (fun keyword ->
          after_word keyword 0)
  | _ -> rule whole before after

(* What is begun says more than what might go on. *)
let rank { Parser_state.whole; before; after } =
  match (whole, before, after) with
  | "expr", [ "expr" ], _ | "items", _, _ -> 2
  | _, _, [] -> 1
  | _ -> 0

let of_items items =
  let by_rank a b = Int.compare (rank a) (rank b) in
  List.find_map of_item (List.stable_sort by_rank items)

let of_state state =
  match of_items Parser_state.items.(state) with
  | Some expectation -> expectation
  | None -> { noun = "keyword"; advice = "" }
