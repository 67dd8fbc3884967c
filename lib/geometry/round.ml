let box circles (axis : Direction.t) =
  let { Vec3.x; y; z } = (axis :> Vec3.t) in
  let across a b = sqrt ((a *. a) +. (b *. b)) in
  let extent = Vec3.make (across y z) (across z x) (across x y) in
  let ends (centre, radius) =
    let reach = Vec3.scale radius extent in
    [ Vec3.sub centre reach; Vec3.add centre reach ]
  in
  Box3.around (List.concat_map ends circles)

let place circles =
  List.sort compare circles
  |> List.concat_map (fun ({ Vec3.x; y; z }, radius) -> [ x; y; z; radius ])
  |> Array.of_list

(* Two directions at right angles to [axis] and to each other. *)
let frame (axis : Direction.t) =
  let a = (axis :> Vec3.t) in
  let aside =
    if abs_float a.x < 0.6 then Vec3.make 1. 0. 0. else Vec3.make 0. 1. 0.
  in
  let u = (Direction.of_vec3_exn (Vec3.cross a aside) :> Vec3.t) in
  (u, Vec3.cross a u)

(* of 15 degrees *)
let cos_step = (sqrt 6. +. sqrt 2.) /. 4.
let sin_step = (sqrt 6. -. sqrt 2.) /. 4.

let rim axis (centre, radius) =
  let u, v = frame axis in
  let turn (c, s) =
    ((c *. cos_step) -. (s *. sin_step), (s *. cos_step) +. (c *. sin_step))
  in
  let point (c, s) =
    Vec3.add centre
      (Vec3.add (Vec3.scale (radius *. c) u) (Vec3.scale (radius *. s) v))
  in
  List.of_seq (Seq.map point (Seq.take 24 (Seq.iterate turn (1., 0.))))
