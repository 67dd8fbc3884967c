open Raylab_expression

exception Too_deep

let position : type a. a Written.kind -> Expression.position = function
  | Number _ | Whole _ -> Number
  | Color | Vector | Direction | Pattern _ -> Color

let rec arguments : type make made.
    (make, made) Written.parameters ->
    (Expression.position * Expression.t) list = function
  | [] -> []
  | { kind; written; _ } :: rest -> (position kind, written) :: arguments rest

let rec surface depth { Syntax.finish; span } : Expression.t =
  if depth = 0 then raise_notrace Too_deep;
  let part s = (Expression.Surface, surface (depth - 1) s) in
  match finish with
  | Plain { word; written = Written { parameters; _ } } ->
      { desc = Word { word; arguments = arguments parameters }; span }
  | Mixed parts ->
      let weight : Syntax.weight -> _ = function
        | Factor e -> (Expression.Weight, e)
        | Tint e -> (Expression.Color, e)
      in
      let weighted (w, s) = [ weight w; part s ] in
      let arguments = List.concat_map weighted parts in
      { desc = Word { word = "mixed"; arguments }; span }
  | Checker (size, even, odd) ->
      let arguments = [ (Expression.Number, size); part even; part odd ] in
      { desc = Word { word = "checker"; arguments }; span }
  | Varying { name; name_span; body } ->
      let body = surface (depth - 1) body in
      { desc = Varying { name; name_span; body }; span }
  | Chosen e -> e

let make s =
  match surface Raylab_scene.Surface.max_nesting s with
  | e -> Some e
  | exception Too_deep -> None
