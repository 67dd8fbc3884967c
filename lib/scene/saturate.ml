let[@inline] limit x =
  if x <= max_float then x else if x > max_float then max_float else 0.

let color (c : Color.t) = Color.make (limit c.r) (limit c.g) (limit c.b)
