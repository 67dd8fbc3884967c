type t = Number of float | Vector of Vec3.t

let equal a b =
  match (a, b) with
  | Number a, Number b -> a = b
  | Vector a, Vector b -> Vec3.equal a b
  | (Number _ | Vector _), _ -> false
