(* generate vim|textmate: colours for the scene language in an editor, from the
   tables of its words. *)

open Raylab_language
open Raylab_expression

(* {1 The words} *)

type group = {
  name : string; (* in Vim *)
  highlight : string; (* what Vim takes for it *)
  scope : string; (* what TextMate calls it *)
  words : string list;
}

let of_role role =
  let word (row : Keyword.t) =
    if row.role = role then Some row.word else None
  in
  List.filter_map word Keyword.table

let group name highlight scope words = { name; highlight; scope; words }

(* Words that are never names, also in brackets. *)
let structure =
  group "Structure" "Statement" "keyword.control" (of_role Structure)

(* What words mean where they are no names. *)
let outside =
  [
    structure;
    group "Setting" "Identifier" "support.type.property-name" (of_role Setting);
    group "Heading" "Label" "keyword.other.heading" (of_role Heading);
    group "Light" "Type" "support.class.light" (of_role Light);
    group "Shape" "Type" "support.class.shape"
      (of_role Shape @ of_role Grouping);
    group "Surface" "StorageClass" "support.type.surface" (of_role Surface);
    group "Modifier" "PreProc" "keyword.other.modifier" (of_role Modifier);
    group "Colour" "Constant" "constant.language.colour" (of_role Color);
  ]

let constants = "time" :: List.map (fun (name, _, _) -> name) Builtin.constants

let inside =
  [
    structure;
    group "Operator" "Operator" "keyword.operator.word" (of_role Operator);
    group "Function" "Function" "support.function"
      (List.map (fun (f : Builtin.t) -> f.name) Builtin.all);
    group "Constant" "Constant" "constant.language" constants;
  ]

(* {1 Vim} *)

let vim_group ?(contained = false) { name; words; _ } =
  Printf.printf "syntax keyword raylab%s%s %s\n" name
    (if contained then " contained" else "")
    (String.concat " " words)

let vim_link { name; highlight; _ } =
  Printf.printf "highlight default link raylab%s %s\n" name highlight

let vim () =
  print_string
    {|" Vim syntax file
" Language: scenes of raylab
" It is made of raylab's own table of words.

if exists("b:current_syntax")
  finish
endif

syntax case ignore
syntax iskeyword @,48-57,_

|};
  List.iter vim_group outside;
  List.iter
    (vim_group ~contained:true)
    (List.map
       (fun group ->
         if group == structure then { group with name = "Inner" } else group)
       inside);
  print_string
    {|
syntax match raylabNumber "\%(\w\|\.\)\@1<![+-]\?\%(\d\+\.\?\d*\|\.\d\+\)\%(e[+-]\?\d\+\)\?\%(\w\|\.\)\@!"
syntax match raylabNumberInside contained "\%(\w\|\.\)\@1<!\%(\d\+\.\?\d*\|\.\d\+\)\%(e[+-]\?\d\+\)\?"
syntax match raylabName "\%(\<let\_s\+\)\@<=\h\w*"
syntax region raylabText start=+"+ end=+"+ oneline
syntax match raylabComment "#.*$" contains=raylabTodo
syntax keyword raylabTodo contained TODO FIXME
syntax region raylabBracket transparent start="(" end=")" contains=@raylabInside
syntax region raylabBracket transparent start="\[" end="\]" contains=@raylabInside
syntax cluster raylabInside contains=raylabBracket,raylabInner,raylabOperator,raylabFunction,raylabConstant,raylabNumberInside,raylabText,raylabComment

|};
  List.iter vim_link (outside @ List.tl inside);
  print_string
    {|highlight default link raylabInner Statement
highlight default link raylabNumber Number
highlight default link raylabNumberInside Number
highlight default link raylabName Function
highlight default link raylabText String
highlight default link raylabComment Comment
highlight default link raylabTodo Todo

let b:current_syntax = "raylab"
|}

(* {1 TextMate} *)

type json =
  | Text of string
  | List of json list
  | Object of (string * json) list

let rec print_json indent = function
  | Text text ->
      let escape = function
        | '"' -> "\\\""
        | '\\' -> "\\\\"
        | c -> String.make 1 c
      in
      Printf.sprintf "\"%s\""
        (String.concat "" (List.map escape (List.of_seq (String.to_seq text))))
  | List items ->
      print_items indent "[" "]" (List.map (fun i -> ("", i)) items)
  | Object members ->
      let label (name, value) = (Printf.sprintf "\"%s\": " name, value) in
      print_items indent "{" "}" (List.map label members)

and print_items indent opening closing items =
  let inner = indent ^ "  " in
  let item (label, value) = inner ^ label ^ print_json inner value in
  Printf.sprintf "%s\n%s\n%s%s" opening
    (String.concat ",\n" (List.map item items))
    indent closing

let scope name = Text (name ^ ".raylab")
let pattern name regex = Object [ ("name", scope name); ("match", Text regex) ]

let words { scope; words; _ } =
  pattern scope
    (Printf.sprintf "(?i)(?<![\\w.])(?:%s)(?!\\w)" (String.concat "|" words))

let include_ name = Object [ ("include", Text ("#" ^ name)) ]

let bracket opening closing =
  Object
    [
      ("begin", Text ("\\" ^ opening));
      ("end", Text ("\\" ^ closing));
      ("patterns", List [ include_ "expression" ]);
    ]

let definition =
  Object
    [
      ("match", Text "(?i)(?<!\\w)(let)\\s+([A-Za-z_]\\w*)");
      ( "captures",
        Object
          [
            ("1", Object [ ("name", scope "keyword.control") ]);
            ("2", Object [ ("name", scope "entity.name.function") ]);
          ] );
    ]

let unsigned = "(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][+-]?\\d+)?"

let textmate () =
  let common =
    [
      pattern "comment.line.number-sign" "#.*$";
      pattern "string.quoted.double" "\"[^\"]*\"";
    ]
  and brackets = include_ "bracket" in
  let grammar =
    Object
      [
        ("name", Text "raylab scene");
        ("scopeName", Text "source.raylab");
        ("fileTypes", List [ Text "scene" ]);
        ("patterns", List [ include_ "item" ]);
        ( "repository",
          Object
            [
              ( "item",
                Object
                  [
                    ( "patterns",
                      List
                        (common
                        @ [
                            brackets;
                            definition;
                            pattern "constant.numeric"
                              ("(?<![\\w.])[+-]?" ^ unsigned ^ "(?![\\w.])");
                          ]
                        @ List.map words outside) );
                  ] );
              ( "bracket",
                Object
                  [ ("patterns", List [ bracket "(" ")"; bracket "[" "]" ]) ]
              );
              ( "expression",
                Object
                  [
                    ( "patterns",
                      List
                        (common
                        @ [
                            brackets;
                            pattern "constant.numeric"
                              ("(?<![\\w.])" ^ unsigned);
                            pattern "keyword.operator" "<>|<=|>=|[-+*/^=<>]";
                          ]
                        @ List.map words inside) );
                  ] );
            ] );
      ]
  in
  print_endline (print_json "" grammar)

let () =
  match Sys.argv with
  | [| _; "vim" |] -> vim ()
  | [| _; "textmate" |] -> textmate ()
  | _ ->
      prerr_endline "generate vim|textmate";
      exit 2
