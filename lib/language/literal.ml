open Raylab_geometry
open Raylab_scene

exception Computed

let number { Raylab_expression.Expression.desc; _ } =
  match desc with Number x -> x | _ -> raise_notrace Computed

let vector { Raylab_expression.Expression.desc; _ } =
  match desc with
  | Triple (x, y, z) -> Vec3.make (number x) (number y) (number z)
  | _ -> raise_notrace Computed

let color e =
  let { Vec3.x; y; z } = vector e in
  Color.make x y z

let shape = function
  | Syntax.Sphere { centre; radius } ->
      let centre = vector centre in
      Shape.sphere ~centre ~radius:(number radius)
  | Plane { point; normal } ->
      let point = vector point in
      Shape.plane ~point ~normal:(vector normal)

let rec surface nesting { Syntax.finish; _ } =
  match finish with
  | Diffusive c -> Surface.diffusive (color c)
  | Reflective -> Surface.reflective
  | Luminous c -> Surface.luminous (color c)
  | Mixed _ when nesting = Surface.max_nesting -> raise_notrace Computed
  | Mixed parts ->
      let part (weight, s) = (number weight, surface (nesting + 1) s) in
      Surface.mixed (List.map part parts)
  | Chosen _ -> raise_notrace Computed

let object_ (placed : Syntax.placed) =
  match placed with
  | { thing = Shape (written, s); modifiers = []; span } -> (
      match
        Object.make ~origin:(Literal span.start) (shape written) (surface 0 s)
      with
      | built -> Syntax.Ready_object built
      | exception (Computed | Invalid_argument _) -> Placed placed)
  | _ -> Placed placed

let light (placed : Syntax.placed) =
  match placed with
  | { thing = Light { source; intensity; color = c }; modifiers = []; span }
    -> (
      let build () =
        let intensity = number intensity and color = color c in
        match source with
        | Directional d ->
            Light.directional ~intensity ~color ~direction:(vector d)
        | Spherical p -> Light.spherical ~intensity ~color ~position:(vector p)
      in
      match Light.with_origin (Literal span.start) (build ()) with
      | built -> Syntax.Ready_light built
      | exception (Computed | Invalid_argument _) -> Placed placed)
  | _ -> Placed placed
