open Raylab_scene
open Raylab_expression

let attempt check frame f = Check.attempt check frame Surface.reflective f
let too_deep = "mixes are nested deeper than 1,000"

let fail_deep span =
  Fault.fail span too_deep
    ~advice:"a mix in a mix may be written as one, with its weights multiplied"

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
  | Plain written ->
      Evaluate_written.compile check scope span ~default:Surface.reflective
        written
  | Mixed _ when depth = Surface.max_nesting ->
      fun frame -> attempt check frame (fun () -> fail_deep span)
  | Mixed parts -> mixed depth check scope span parts
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
        with Invalid_argument _ -> Fault.fail span too_deep)

let compile check scope surface = nested 0 check scope surface
