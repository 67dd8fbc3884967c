open Raylab_geometry

let pi = Float.pi

(* A torus with ruffles, cut into about [triangles] triangles. *)
let grid ~triangles =
  let vs = Int.max 8 (Float.to_int (sqrt (float_of_int triangles /. 6.))) in
  (3 * vs, vs)

let point ~us ~vs i j =
  let u = 2. *. pi *. float_of_int i /. float_of_int us
  and v = 2. *. pi *. float_of_int j /. float_of_int vs in
  let r = 0.6 +. (0.05 *. sin (14. *. u) *. sin (6. *. v)) in
  let across = 1.2 +. (r *. cos v) in
  Vec3.make
    (across *. cos u)
    ((r *. sin v *. 0.8) +. (across *. sin u *. 0.6))
    ((across *. sin u *. 0.8) -. (r *. sin v *. 0.6) +. 4.5)

(* As many digits as the file has. *)
let rounded x = Float.round (x *. 1e6) /. 1e6

let facets ~triangles =
  let us, vs = grid ~triangles in
  let points =
    Array.init (us * vs) (fun k ->
        let { Vec3.x; y; z } = point ~us ~vs (k / vs) (k mod vs) in
        [| rounded x; rounded y; rounded z |])
  in
  let at i j = (i mod us * vs) + (j mod vs) in
  let quad k =
    let i = k / vs and j = k mod vs in
    let a = at i j and b = at i (j + 1) in
    let c = at (i + 1) (j + 1) and d = at (i + 1) j in
    [| a; b; c; a; c; d |]
  in
  let count = 2 * us * vs in
  {
    Facets.none with
    points = Array.concat (Array.to_list points);
    corners = Array.concat (List.init (us * vs) quad);
    faces = Array.init count (fun k -> k + 1);
    places = Array.make count 0;
  }

let mesh ~name ~triangles = Mesh.make ~name (facets ~triangles)

let write channel mesh =
  let { Facets.points; corners; _ } = Mesh.facets mesh in
  for k = 0 to (Array.length points / 3) - 1 do
    Printf.fprintf channel "v %.6f %.6f %.6f\n"
      points.(3 * k)
      points.((3 * k) + 1)
      points.((3 * k) + 2)
  done;
  for k = 0 to (Array.length corners / 3) - 1 do
    let corner n = corners.((3 * k) + n) + 1 in
    Printf.fprintf channel "f %d %d %d\n" (corner 0) (corner 1) (corner 2)
  done
