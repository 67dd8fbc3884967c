let unit high =
  let size = abs_float high in
  if size = max_float then size -. Float.pred size else Float.succ size -. size

(* the difference of the doubles is exact, since they are close *)
let error x ~high ~low = abs_float (x -. high -. low) /. unit high
