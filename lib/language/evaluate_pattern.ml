open Raylab_expression

(* What is printed must not take over a word. *)
let reserved name =
  Option.is_some (Keyword.token name)
  || Option.is_some (Keyword.reserved_inside name)

let surface = function Thing.Surface s -> Some s | Light _ | Object _ -> None

let make ~thing scope ~at name written (frame : Check.frame) =
  let around = Function.around scope frame in
  Closed.make ~reserved ~thing ~run:frame.run ~around ~at name written
