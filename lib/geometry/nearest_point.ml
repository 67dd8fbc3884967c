open Vec3

(* The nearest on the way from [a] to [b]. *)
let of_segment p a b =
  let way = sub b a in
  let squared = length_squared way in
  let t = if squared > 0. then dot (sub p a) way /. squared else 0. in
  add a (scale (Float.max 0. (Float.min 1. t)) way)

(* Where [p] lies above the triangle, its foot; else the nearest of the three
   edges. *)
let of_triangle p a b c =
  let normal = cross (sub b a) (sub c a) in
  let beside a b = dot (cross normal (sub b a)) (sub p a) in
  let squared = length_squared normal in
  if squared > 0. && beside a b >= 0. && beside b c >= 0. && beside c a >= 0.
  then sub p (scale (dot (sub p a) normal /. squared) normal)
  else
    let nearer q r =
      if length_squared (sub p r) < length_squared (sub p q) then r else q
    in
    nearer (of_segment p a b) (nearer (of_segment p b c) (of_segment p c a))
