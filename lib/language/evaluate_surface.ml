open Raylab_scene
open Raylab_expression

let attempt check frame f = Check.attempt check frame Surface.reflective f

let mixes_too_deep span =
  Fault.fail span "mixes are nested deeper than 1,000"
    ~advice:"a mix in a mix may be written as one, with its weights multiplied"

let checkers_too_deep span =
  Fault.fail span "checkers are nested deeper than 1,000"

let varying_too_deep span =
  Fault.fail span "surfaces are nested deeper than 1,000"

let chosen check scope e =
  let code = Code.compile scope e in
  fun frame ->
    attempt check frame (fun () ->
        match code frame with
        | Value.Thing (Thing.Surface s) -> s
        | value -> Operation.wanted frame.Frame.run e "a surface" value)

let weight_of check scope : Syntax.weight -> Color.t Check.ready = function
  | Factor e ->
      let factor =
        Evaluate_written.number check scope Non_negative "the weight" e
      in
      fun frame ->
        let factor = factor frame in
        Color.make factor factor factor
  | Tint e -> Evaluate_written.color check scope "the weight" e

let rec nested depth check scope { Syntax.finish; span } :
    Surface.t Check.ready =
  match finish with
  | Plain { written; _ } ->
      Evaluate_written.compile check scope span ~default:Surface.reflective
        written
  | Mixed _ when depth = Surface.max_nesting ->
      fun frame -> attempt check frame (fun () -> mixes_too_deep span)
  | Checker _ when depth = Surface.max_nesting ->
      fun frame -> attempt check frame (fun () -> checkers_too_deep span)
  | Mixed parts -> mixed depth check scope span parts
  | Checker (size, even, odd) -> checker depth check scope span size even odd
  | Varying { name; name_span; body } ->
      varying depth check scope span name name_span body
  | Chosen e -> chosen check scope e

and mixed depth check scope span parts =
  let part (weight, s) =
    (weight_of check scope weight, nested (depth + 1) check scope s)
  in
  let parts = List.map part parts in
  fun frame ->
    let part (weight, surface) =
      let weight = weight frame in
      (weight, surface frame)
    in
    let parts = List.map part parts in
    attempt check frame (fun () ->
        try Surface.tinted parts
        with Invalid_argument _ -> mixes_too_deep span)

and checker depth check scope span size even odd =
  let size =
    Evaluate_written.number check scope Positive "the size of the checker" size
  and even = nested (depth + 1) check scope even
  and odd = nested (depth + 1) check scope odd in
  fun frame ->
    let size = size frame in
    let even = even frame in
    let odd = odd frame in
    attempt check frame (fun () ->
        (* what has a name may be in it many times *)
        Budget.steps frame.Frame.run.budget span
          (Surface.count even + Surface.count odd);
        try Surface.checker size even odd
        with Invalid_argument _ -> checkers_too_deep span)

(* What is in it is made ready as well, so that what is wrong is told whether or
   not it is seen. *)
and varying depth check scope span name name_span body =
  let inner, _ = Scope.bind scope name name_span in
  let deeper : Surface.t Check.ready = nested (depth + 1) check inner body in
  ignore deeper;
  match Surface_expression.make body with
  | None -> fun frame -> attempt check frame (fun () -> varying_too_deep span)
  | Some written ->
      fun frame ->
        attempt check frame (fun () ->
            let thing = Evaluate_pattern.surface in
            let pattern =
              Evaluate_pattern.make ~thing scope ~at:span name written frame
            in
            try Surface.varying pattern
            with Invalid_argument _ -> varying_too_deep span)

let compile check scope surface = nested 0 check scope surface
