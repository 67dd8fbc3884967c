open Raylab_scene
open Raylab_expression

let brackets = "What is computed stands in brackets, such as "

(* {1 Words outside of brackets} *)

let is_operator c = String.contains "+-*/^<>=" c
let is_letter c = ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c = '_'
let is_part c = is_letter c || ('0' <= c && c <= '9')

(* Whether an operator joins two parts of [word], from [k] on. *)
let rec joins word k =
  k < String.length word - 1
  && (is_operator word.[k]
      && word.[k] <> '-'
      && is_part word.[k - 1]
      && is_part word.[k + 1]
     || joins word (k + 1))

(* [+], [<=], [-far] and [2*3], but no [light-source]. *)
let is_computed word =
  String.for_all is_operator word
  || (word.[0] = '-' && String.length word > 1 && is_letter word.[1])
  || joins word 1

let without_sign word =
  if String.length word > 1 && (word.[0] = '-' || word.[0] = '+') then
    String.sub word 1 (String.length word - 1)
  else word

let gives_vector (f : Builtin.t) =
  match f.body with Vector _ | Vectors _ | To_vector _ -> true | _ -> false

let of_function word (f : Builtin.t) =
  let sign = String.sub word 0 (String.length word - String.length f.name) in
  let call = Printf.sprintf "%s%s(...)" sign f.name in
  brackets
  ^
  if gives_vector f then Printf.sprintf "[%s]." call
  else Printf.sprintf "(%s)." call

let starts_with prefixes word =
  List.exists (fun prefix -> String.starts_with ~prefix word) prefixes

let computed word =
  match Builtin.find (String.lowercase_ascii (without_sign word)) with
  | Some f -> Some (of_function word f)
  | None when is_computed word -> Some (brackets ^ "(2 * 3 + 1).")
  | None -> None

let of_word word =
  match String.lowercase_ascii word with
  | "then" -> Some "The items follow the condition at once, as far as end."
  | "rgb" -> Some "A colour is three numbers, such as 1 0.5 0."
  | _ when starts_with [ "//"; "/*" ] word ->
      Some "A comment starts with #, and ends with the line."
  | _ when starts_with [ "<" ] word && String.exists is_part word ->
      Some "A point or a colour is three numbers, with nothing around."
  | _ when starts_with [ "{"; "}" ] word ->
      Some "A block has no braces, and ends with the word end."
  | _ when String.ends_with ~suffix:";" word ->
      Some "No semicolon stands between the parts of a scene."
  | _ -> computed word

(* {1 Operators of other languages} *)

let of_operator = function
  | "&&" | "&" -> Some "That both hold is written and."
  | "||" | "|" -> Some "That one of two holds is written or."
  | "!" -> Some "That something does not hold is written not."
  | "%" -> Some "The rest of a division is mod(a, b)."
  | "?" -> Some "A choice is written if A then B else C."
  | _ -> None

(* {1 Tokens} *)

let advice ~acceptable ~expected ~text (token : Parser.token) =
  let inside = expected = "operator" in
  match token with
  | WORD _ when expected = "file name" -> None
  | WORD word when inside -> of_operator word
  | WORD word -> of_word word
  | COMMA when inside ->
      Some "A point, a colour or a list stands in [ ], such as [1, 2, 3]."
  | LBRACKET when inside ->
      Some "An element of a list is nth(list, 0), counted from 0."
  | EQUAL when acceptable Parser.SPHERE ->
      Some "A name keeps the value that it has; let gives one to another name."
  | LPAREN when acceptable Parser.SPHERE ->
      Some "A function has its bracket at once behind its name: ball(2)."
  | LPAREN when expected = "'='" ->
      Some
        "A function has its bracket at once behind its name: let ball(x) = ..."
  | NUMBER _ when expected = "list" ->
      Some (Printf.sprintf "To count, write = %s to ..." text)
  | _ -> None

(* {1 Names in brackets} *)

let of_color name { Color.r; g; b } =
  let number = Raylab_geometry.Number.to_exact_string in
  Printf.sprintf
    "in brackets write [%s, %s, %s], or a name for it, as in let paint = %s"
    (number r) (number g) (number b) name

let of_name name =
  match Keyword.find name with
  | Some { token = COLOR color; word; _ } -> Some (of_color word color)
  | Some { role = Surface | Light | Shape | Grouping; word; _ } ->
      Some
        (Printf.sprintf
           "%s does not stand in brackets: give what it makes a name by let"
           word)
  | _ -> None
