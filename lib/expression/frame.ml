type 'thing t = {
  mutable slots : 'thing Value.t array;
  outer : 'thing t;
  run : 'thing Value.run;
}

let start run ~size =
  let rec frame =
    { slots = Array.make size Value.Undefined; outer = frame; run }
  in
  frame

let need frame size =
  let present = Array.length frame.slots in
  if size > present then
    let more = Array.make (Int.max 8 (size + present)) Value.Undefined in
    frame.slots <- Array.append frame.slots more

(* Names are bound in the innermost function only. *)
let set ({ slot; _ } : Scope.binding) frame value =
  if slot >= Array.length frame.slots then need frame (slot + 1);
  frame.slots.(slot) <- value

let rec up frame levels =
  if levels = 0 then frame else up frame.outer (levels - 1)

let read (binding : Scope.binding) ~levels =
  let slot = binding.slot in
  let read frame =
    match frame.slots.(slot) with
    | Value.Undefined -> raise Fault.Known
    | value -> value
  in
  match levels with
  | 0 -> read
  | 1 -> fun frame -> read frame.outer
  | levels -> fun frame -> read (up frame levels)
