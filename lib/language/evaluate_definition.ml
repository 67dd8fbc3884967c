open Raylab_expression

let value block check scope (value : Syntax.value) : Thing.t Code.t =
  match value with
  | Expression e -> Code.compile scope e
  | Surface s ->
      let surface =
        Check.whole check (Evaluate_surface.compile check scope s)
      in
      fun frame -> Thing (Surface (surface frame))
  | Thing placed ->
      let thing =
        Check.whole check (Evaluate_thing.compile block check scope placed)
      in
      fun frame -> Thing (thing frame)

(* What can be evaluated in a pattern. *)
let as_expression : Syntax.value -> Expression.t option = function
  | Expression e -> Some e
  | Surface s -> Surface_expression.make s
  | Thing _ -> None

let compile block check scope definition =
  let { Syntax.name; name_span; parameters; value = written } = definition in
  let is_function = Option.is_some parameters in
  let inner, binding =
    Scope.bind scope name name_span ~is_defined:is_function
  in
  let value scope = value block check scope written in
  let code =
    match parameters with
    | None -> value inner
    | Some parameters ->
        Function.compile inner ~name ?written:(as_expression written)
          parameters value
  in
  binding.is_defined <- true;
  ( inner,
    fun frame ->
      Frame.set binding frame
        (Check.attempt check frame Value.Undefined (fun () -> code frame)) )
