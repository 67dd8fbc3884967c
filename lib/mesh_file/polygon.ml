let max_concave = 5_000

(* The two axes along which the polygon is seen at its largest, in the order in
   which it is wound as a positive angle; M. Newell's normal, as in I. E.
   Sutherland, R. F. Sproull and R. A. Schumacker, A characterization of ten
   hidden-surface algorithms, 1974. *)
let view ~points ~count =
  let along a b =
    let sum = ref 0. in
    for k = 0 to count - 1 do
      let next = if k + 1 = count then 0 else k + 1 in
      sum :=
        !sum +. ((points k a -. points next a) *. (points k b +. points next b))
    done;
    !sum
  in
  let x = along 1 2 and y = along 2 0 and z = along 0 1 in
  let ax = abs_float x and ay = abs_float y and az = abs_float z in
  let axes a b n = if n > 0. then (a, b) else (b, a) in
  if ax >= ay && ax >= az then axes 1 2 x
  else if ay >= az then axes 2 0 y
  else axes 0 1 z

let fan ~count triangle =
  for k = 1 to count - 2 do
    triangle 0 k (k + 1)
  done

(* Cuts off corners that bulge and in whose triangle no other corner lies, until
   a triangle is left. [next] and [previous] link the corners that are left. *)
let clip_ears ~turn ~same ~count triangle =
  let next = Array.init count (fun k -> if k + 1 = count then 0 else k + 1)
  and previous =
    Array.init count (fun k -> if k = 0 then count - 1 else k - 1)
  in
  let bulges k = turn previous.(k) k next.(k) > 0. in
  let is_ear k =
    let a = previous.(k) and c = next.(k) in
    let within p =
      turn a k p >= 0.
      && turn k c p >= 0.
      && turn c a p >= 0.
      && not (same p a || same p k || same p c)
    in
    let rec free p = p = a || ((not (within p)) && free next.(p)) in
    bulges k && free next.(c)
  in
  let cut k =
    triangle previous.(k) k next.(k);
    next.(previous.(k)) <- next.(k);
    previous.(next.(k)) <- previous.(k)
  in
  (* [tried] corners before [k] are no ears *)
  let rec go k left tried =
    if left = 3 then triangle previous.(k) k next.(k)
    else if tried >= left || is_ear k then (
      let before = previous.(k) in
      cut k;
      go before (left - 1) 0)
    else go next.(k) left (tried + 1)
  in
  go 1 count 0

let cut ~points ~count triangle =
  if count = 3 then (
    triangle 0 1 2;
    true)
  else
    let u, v = view ~points ~count in
    let turn a b c =
      ((points b u -. points a u) *. (points c v -. points a v))
      -. ((points b v -. points a v) *. (points c u -. points a u))
    in
    (* no corner turns back, nor is one seen from the first out of order *)
    let rec is_convex k =
      k = count
      || turn k ((k + 1) mod count) ((k + 2) mod count) >= 0.
         && turn 0 k ((k + 1) mod count) >= 0.
         && is_convex (k + 1)
    in
    if is_convex 0 then (
      fan ~count triangle;
      true)
    else if count > max_concave then false
    else
      let same a b = points a u = points b u && points a v = points b v in
      clip_ears ~turn ~same ~count triangle;
      true
