(* [max_float], as a constant that the compiler sees: the tracer compares with
   it a dozen times a hit. *)
let largest = 0x1.fffffffffffffp+1023

let[@inline] limit x =
  if x <= largest then x else if x > largest then largest else 0.

let color (c : Color.t) = Color.make (limit c.r) (limit c.g) (limit c.b)
