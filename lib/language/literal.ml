open Raylab_geometry
open Raylab_scene

exception Computed

let number { Raylab_expression.Expression.desc; _ } =
  match desc with Number x -> x | _ -> raise_notrace Computed

let vector { Raylab_expression.Expression.desc; _ } =
  match desc with
  | Triple (x, y, z) -> Vec3.make (number x) (number y) (number z)
  | _ -> raise_notrace Computed

let parameter : type a. a Written.parameter -> a =
 fun { kind; written; _ } ->
  match kind with
  | Number _ -> number written
  | Vector -> vector written
  | Direction -> vector written
  | Color ->
      let { Vec3.x; y; z } = vector written in
      Color.make x y z
  | Whole _ | Pattern _ -> raise_notrace Computed

let rec apply : type make made. (make, made) Written.parameters -> make -> made
    =
 fun parameters make ->
  match parameters with
  | [] -> make
  | first :: rest -> apply rest (make (parameter first))

let build (Written.Written { parameters; make }) = apply parameters make

let weight : Syntax.weight -> Color.t = function
  | Factor x ->
      let x = number x in
      Color.make x x x
  | Tint _ -> raise_notrace Computed

let rec surface nesting { Syntax.finish; _ } =
  match finish with
  | Plain { written; _ } -> build written
  | Mixed _ when nesting = Surface.max_nesting -> raise_notrace Computed
  | Mixed parts ->
      let part (w, s) = (weight w, surface (nesting + 1) s) in
      Surface.tinted (List.map part parts)
  | Checker _ when nesting = Surface.max_nesting -> raise_notrace Computed
  | Checker (size, even, odd) ->
      let even = surface (nesting + 1) even in
      Surface.checker (number size) even (surface (nesting + 1) odd)
  | Varying _ | Chosen _ -> raise_notrace Computed

let item (placed : Syntax.placed) =
  let build { Syntax.thing; modifiers; span } =
    let origin = Origin.Literal span.start in
    match (thing, modifiers) with
    | Shape (shape, finish), [] ->
        let shape = build shape in
        Syntax.Ready_object (Object.make ~origin shape (surface 0 finish))
    | Light light, [] -> Ready_light (Light.with_origin origin (build light))
    | _ -> raise_notrace Computed
  in
  try build placed
  with Computed | Written.Refused _ | Invalid_argument _ -> Placed placed
