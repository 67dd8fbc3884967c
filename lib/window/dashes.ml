let cut (dash, gap) ((x, y), (x', y')) =
  let at t = (x +. (t *. (x' -. x)), y +. (t *. (y' -. y))) in
  let length = Float.hypot (x' -. x) (y' -. y) in
  let period = dash +. gap in
  List.init
    (int_of_float (Float.ceil (length /. period)))
    (fun k ->
      let start = float_of_int k *. period in
      (at (start /. length), at (Float.min 1. ((start +. dash) /. length))))
