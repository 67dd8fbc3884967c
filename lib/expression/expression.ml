open Raylab_geometry
open Raylab_source

type parameter = { name : string; span : Span.t; default : t option }
and t = { desc : desc; span : Span.t }

and desc =
  | Number of float
  | Truth of bool
  | Text of string
  | Name of string
  | Call of { name : string; name_span : Span.t; arguments : argument list }
  | Triple of t * t * t
  | List of t list
  | Series of { name : string; name_span : Span.t; range : range; body : t }
  | Part of t * char
  | Negative of t
  | Not of t
  | Binary of operator * t * t
  | If of t * t * t
  | Let of { name : string; name_span : Span.t; value : t; body : t }
  | Word of { word : string; arguments : (position * t) list }
  | Varying of { name : string; name_span : Span.t; body : t }

and position = Number | Color | Weight | Surface
and range = To of { first : t; last : t; step : t option } | In of t
and argument = { label : (string * Span.t) option; value : t }

and operator =
  | Add
  | Subtract
  | Multiply
  | Divide
  | Power
  | Equal
  | Different
  | Less
  | Less_or_equal
  | Greater
  | Greater_or_equal
  | And
  | Or

let symbol = function
  | Add -> "+"
  | Subtract -> "-"
  | Multiply -> "*"
  | Divide -> "/"
  | Power -> "^"
  | Equal -> "="
  | Different -> "<>"
  | Less -> "<"
  | Less_or_equal -> "<="
  | Greater -> ">"
  | Greater_or_equal -> ">="
  | And -> "and"
  | Or -> "or"

(* {1 Printing}

   How tightly what is printed holds together, from [whole] on; the operands of
   an operator must hold at least as tightly as it asks. *)

let whole = 0
let comparison = 4
let sum = 5
let negative = 7
let primary = 9

let operand_levels = function
  | Or -> (1, 1, 2)
  | And -> (2, 2, 3)
  | Equal | Different | Less | Less_or_equal | Greater | Greater_or_equal ->
      (comparison, sum, sum)
  | Add | Subtract -> (sum, sum, 6)
  | Multiply | Divide -> (6, 6, negative)
  | Power -> (8, primary, negative)

let level = function
  | Number x -> if x < 0. then negative else primary
  | Truth _ | Text _ | Name _ | Call _ | Triple _ | List _ | Series _ | Part _
  | Word _ | Varying _ ->
      primary
  | Negative _ -> negative
  | Not _ -> 3
  | Binary (operator, _, _) ->
      let own, _, _ = operand_levels operator in
      own
  | If _ | Let _ -> whole

let pp_separated pp_one ppf list =
  List.iteri
    (fun k one ->
      if k > 0 then Format.pp_print_string ppf ", ";
      pp_one ppf one)
    list

let rec pp_at least ppf e =
  if level e.desc < least then Format.fprintf ppf "(%a)" pp_desc e.desc
  else pp_desc ppf e.desc

and pp ppf e = pp_at whole ppf e

and pp_desc ppf = function
  | Number x -> Format.pp_print_string ppf (Number.to_exact_string x)
  | Truth truth -> Format.pp_print_bool ppf truth
  | Text text -> Format.fprintf ppf "\"%s\"" text
  | Name name -> Format.pp_print_string ppf name
  | Call { name; arguments; _ } ->
      Format.fprintf ppf "%s(%a)" name (pp_separated pp_argument) arguments
  | Triple (x, y, z) -> Format.fprintf ppf "[%a]" (pp_separated pp) [ x; y; z ]
  | List elements -> Format.fprintf ppf "[%a]" (pp_separated pp) elements
  | Series { name; range; body; _ } ->
      Format.fprintf ppf "[for %s %a: %a]" name pp_range range pp body
  | Part (e, letter) -> Format.fprintf ppf "%a.%c" (pp_at primary) e letter
  | Negative e -> Format.fprintf ppf "-%a" (pp_at negative) e
  | Not e -> Format.fprintf ppf "not %a" (pp_at 3) e
  | Binary (operator, a, b) ->
      let _, left, right = operand_levels operator in
      Format.fprintf ppf "%a %s %a" (pp_at left) a (symbol operator)
        (pp_at right) b
  | If (condition, a, b) ->
      Format.fprintf ppf "if %a then %a else %a" pp condition pp a pp b
  | Let { name; value; body; _ } ->
      Format.fprintf ppf "let %s = %a in %a" name pp value pp body
  | Word { word; arguments } ->
      Format.pp_print_string ppf word;
      List.iter (fun argument -> pp_bare ppf argument) arguments
  | Varying { name; body; _ } ->
      Format.fprintf ppf "varying %s%a" name pp_bare (Surface, body)

(* After a blank, so that it is what may stand there. *)
and pp_bare ppf (position, e) =
  (* a name of what is built in is one only in brackets *)
  match (position, e.desc) with
  | _, (Number _ | Triple _ | List _ | Series _ | Word _ | Varying _)
  | Surface, Name _ ->
      Format.fprintf ppf " %a" pp_desc e.desc
  | Surface, Call { name; _ }
    when Builtin.find (String.lowercase_ascii name) = None ->
      Format.fprintf ppf " %a" pp_desc e.desc
  | Color, _ -> Format.fprintf ppf " [%a]" pp e
  | (Number | Weight | Surface), _ -> Format.fprintf ppf " (%a)" pp e

and pp_argument ppf ({ label; value } : argument) =
  Option.iter (fun (label, _) -> Format.fprintf ppf "%s: " label) label;
  pp ppf value

and pp_range ppf = function
  | To { first; last; step } ->
      Format.fprintf ppf "= %a to %a" pp first pp last;
      Option.iter (Format.fprintf ppf " by %a" pp) step
  | In e -> Format.fprintf ppf "in %a" pp e

let to_string e =
  let text = Buffer.create 40 in
  let ppf = Format.formatter_of_buffer text in
  Format.fprintf ppf "%a@?" pp e;
  Buffer.contents text

let bare_triple x y z =
  {
    desc = Triple (x, y, z);
    span = { start = x.span.start; stop = z.span.stop };
  }
