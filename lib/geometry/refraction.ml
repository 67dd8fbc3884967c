type t = {
  mutable cosine : float;
  mutable share : float;
  mutable dx : float;
  mutable dy : float;
  mutable dz : float;
}

let create () = { cosine = 0.; share = 1.; dx = 0.; dy = 0.; dz = 1. }
let[@inline] is_total t = t.cosine = 0.

(* Fresnel's equations, of light that comes at the cosine [i] and goes on at
   [o], [eta] times faster than it would have; the mean of the two ways in which
   it can be polarised. *)
let[@inline] fresnel eta i o =
  let across = ((eta *. i) -. o) /. ((eta *. i) +. o)
  and along = (i -. (eta *. o)) /. (i +. (eta *. o)) in
  0.5 *. ((across *. across) +. (along *. along))

let[@inline] set_total t =
  t.cosine <- 0.;
  t.share <- 1.

(* Snell's law multiplies the part of the direction that lies in the surface by
   [eta]. Its square is taken of that part and not of the cosine, so that the
   direction has the length 1 at any angle. *)
let[@inline] meet t (spot : Spot.t) (ray : Raw_ray.t) ~index =
  let { Spot.shading_x = nx; shading_y = ny; shading_z = nz; side; _ } =
    spot
  in
  let eta = if side > 0. then 1. /. index else index in
  let along = (nx *. ray.dx) +. (ny *. ray.dy) +. (nz *. ray.dz) in
  let x = eta *. (ray.dx -. (along *. nx))
  and y = eta *. (ray.dy -. (along *. ny))
  and z = eta *. (ray.dz -. (along *. nz)) in
  let squared_sine = (x *. x) +. (y *. y) +. (z *. z) in
  (* false for NaN, of an index that has no inverse *)
  if squared_sine < 1. then (
    let cosine = sqrt (1. -. squared_sine) in
    let x = x -. (cosine *. nx)
    and y = y -. (cosine *. ny)
    and z = z -. (cosine *. nz) in
    let scale = 1. /. sqrt ((x *. x) +. (y *. y) +. (z *. z)) in
    t.cosine <- cosine;
    t.share <- fresnel eta (if along < 0. then -.along else 0.) cosine;
    t.dx <- x *. scale;
    t.dy <- y *. scale;
    t.dz <- z *. scale)
  else set_total t

let[@inline] share_from_outside ~index cosine =
  let eta = 1. /. index in
  let squared_sine = eta *. eta *. (1. -. (cosine *. cosine)) in
  if squared_sine < 1. then fresnel eta cosine (sqrt (1. -. squared_sine))
  else 1.
