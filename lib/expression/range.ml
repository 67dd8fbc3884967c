let[@inline] modulo x divisor =
  let rest = Float.rem x divisor in
  if rest = 0. then 0.
  else if rest < 0. = (divisor < 0.) then rest
  else
    let rest = rest +. divisor in
    if rest = divisor then 0. else rest

let[@inline] clamp x low high =
  if x < low then low else if x > high then high else x

let[@inline] mix a b t =
  let from = (1. -. t) *. a in
  Exact.mul_add t b from

let[@inline] smoothstep a b x =
  if a = b then if x < a then 0. else 1.
  else
    let t = clamp ((x -. a) /. (b -. a)) 0. 1. in
    t *. t *. Exact.sub_mul 3. 2. t
