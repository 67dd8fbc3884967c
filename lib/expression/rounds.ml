let count ~step_of ~first ~last ~step =
  if step = 0. then
    Fault.fail step_of.Expression.span "the step of a loop must not be 0";
  Float.max 0. (floor (((last -. first) /. step) +. 1e-9) +. 1.)

let value ~first ~step k = first +. (k *. step)
