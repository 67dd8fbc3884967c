let narrow (first, last) ~from ~step low high =
  if step = 0. then
    if low <= from && from <= high then (first, last)
    else (infinity, neg_infinity)
  else
    let a = (low -. from) /. step and b = (high -. from) /. step in
    (Float.max first (Float.min a b), Float.min last (Float.max a b))
