type t = { mutable r : float; mutable g : float; mutable b : float }

let create () = { r = 0.; g = 0.; b = 0. }

let[@inline] set color r g b =
  color.r <- Saturate.limit r;
  color.g <- Saturate.limit g;
  color.b <- Saturate.limit b

let[@inline] mean sum count =
  let n = float_of_int count in
  sum.r <- sum.r /. n;
  sum.g <- sum.g /. n;
  sum.b <- sum.b /. n

let to_color ({ r; g; b } : t) = Color.make r g b
