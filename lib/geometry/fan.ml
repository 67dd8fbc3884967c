open Unchecked

type source =
  | Eye of {
      eye : Vec3.t;
      right : Direction.t;
      above : Direction.t;
      forward : Direction.t;
      width : float;
      height : float;
    }
  | Point of Vec3.t
  | Along of Direction.t

type kind = Of_eye | Of_point | Parallel

type t = {
  kind : kind;
  frame : Fan_view.frame; (* of the only face, or of any *)
  limits : float array; (* how far its rays come from, or half the canvas *)
  faces : Fan_face.t array;
}

(* {1 Making them} *)

let x_axis = Vec3.make 1. 0. 0.
let y_axis = Vec3.make 0. 1. 0.
let z_axis = Vec3.make 0. 0. 1.

(* The six sides of a cube around a point. *)
let cube source =
  let side u v depth =
    [
      Fan_view.frame ~source u v depth;
      Fan_view.frame ~source u v (Vec3.neg depth);
    ]
  in
  side y_axis z_axis x_axis @ side x_axis z_axis y_axis
  @ side x_axis y_axis z_axis

(* Two directions across a third. *)
let across (depth : Direction.t) =
  let { Vec3.x; y; z } = (depth :> Vec3.t) in
  let other =
    if abs_float x <= abs_float y && abs_float x <= abs_float z then x_axis
    else if abs_float y <= abs_float z then y_axis
    else z_axis
  in
  let unit v = (Direction.of_vec3_exn v :> Vec3.t) in
  let u = unit (Vec3.cross (depth :> Vec3.t) other) in
  (u, unit (Vec3.cross (depth :> Vec3.t) u))

let window u v : Fan_view.t =
  {
    (Fan_view.everything ()) with
    least_u = -.u;
    most_u = u;
    least_v = -.v;
    most_v = v;
  }

(* A little more, for the rays on the edge. *)
let wider = 1. +. 1e-6
let half side = wider *. side /. 2.

let frames = function
  | Eye { eye; right; above; forward; width; height } ->
      let window = window (half width) (half height) in
      ( Of_eye,
        window,
        [
          Fan_view.frame ~source:eye
            (right :> Vec3.t)
            (above :> Vec3.t)
            (forward :> Vec3.t);
        ] )
  | Point source -> (Of_point, window wider wider, cube source)
  | Along direction ->
      let u, v = across direction in
      ( Parallel,
        Fan_view.everything (),
        [ Fan_view.frame u v (direction :> Vec3.t) ] )

let largest = 1e100
let widest = 1e6

(* From how many times as far as all shapes are rays may come: what is added to
   the shapes' sizes is far more than the rounding errors on such a way. *)
let farthest = 1e4

(* The faces of [frames], of at most [most] references in all. *)
let rec make_faces leaves ~window ~most = function
  | [] -> Some []
  | frame :: rest ->
      Option.bind (Fan_face.make frame leaves ~window ~most) (fun face ->
          let most = most - Fan_face.length face in
          Option.map (List.cons face) (make_faces leaves ~window ~most rest))

let make leaves ~most source =
  let kind, window, frames = frames source in
  let extent = Fan_face.extent (List.hd frames) leaves in
  let enough_bits = Sys.int_size >= 63
  and is_narrow =
    match source with
    | Eye { width; height; _ } -> width < widest && height < widest
    | Point _ | Along _ -> true
  in
  if
    enough_bits && extent < largest && is_narrow
    && Leaves.count leaves <= Fan_reference.most_places
  then
    let of_faces faces =
      {
        kind;
        frame = List.hd frames;
        limits =
          (match source with
          | Eye { width; height; _ } -> [| half width; half height |]
          | Point _ | Along _ -> [| farthest *. extent |]);
        faces = Array.of_list faces;
      }
    in
    Option.map of_faces (make_faces leaves ~window ~most frames)
  else None

(* {1 Questions} *)

let[@inline] along (axes : float array) at x y z =
  (x *. axes.%(at)) +. (y *. axes.%(at + 1)) +. (z *. axes.%(at + 2))

let has_ray_from { kind; frame; limits; _ } (ray : Raw_ray.t) =
  match kind with
  | Of_point | Parallel -> false
  | Of_eye ->
      let { Fan_view.origin = o; axes; _ } = frame in
      let { Raw_ray.ox; oy; oz; dx; dy; dz; _ } = ray in
      let pace = along axes 6 dx dy dz in
      ox = o.%(0)
      && oy = o.%(1)
      && oz = o.%(2)
      && pace > 0.
      && abs_float (along axes 0 dx dy dz) <= limits.%(0) *. pace
      && abs_float (along axes 3 dx dy dz) <= limits.%(1) *. pace

let nearest { frame; faces; _ } leaves (ray : Raw_ray.t) meeting =
  let { Fan_view.axes; _ } = frame in
  let { Raw_ray.dx; dy; dz; _ } = ray in
  let pace = along axes 6 dx dy dz in
  let scale = 1. /. pace in
  Fan_face.meet ~any:false (Array.unsafe_get faces 0) leaves
    ~u:(along axes 0 dx dy dz *. scale)
    ~v:(along axes 3 dx dy dz *. scale)
    ~pace ~depth:0. ray meeting

let has_ray_to { kind; frame; limits; _ } (ray : Raw_ray.t) =
  match kind with
  | Of_eye -> false
  | Of_point ->
      let o = frame.origin in
      let away =
        abs_float (ray.ox -. o.%(0))
        +. abs_float (ray.oy -. o.%(1))
        +. abs_float (ray.oz -. o.%(2))
      in
      away > 0. && away < limits.%(0)
  | Parallel ->
      abs_float ray.ox +. abs_float ray.oy +. abs_float ray.oz < limits.%(0)

let[@inline never] some_parallel { frame; faces; _ } leaves (ray : Raw_ray.t)
    meeting =
  let { Fan_view.axes; _ } = frame in
  let { Raw_ray.ox; oy; oz; _ } = ray in
  Fan_face.meet ~any:true (Array.unsafe_get faces 0) leaves
    ~u:(along axes 0 ox oy oz) ~v:(along axes 3 ox oy oz) ~pace:0.
    ~depth:(along axes 6 ox oy oz) ray meeting

(* Through the side of the cube on which the ray starts. *)
let[@inline never] some_to_point { frame; faces; _ } leaves (ray : Raw_ray.t)
    meeting =
  let o = frame.origin in
  let x = ray.ox -. o.%(0) and y = ray.oy -. o.%(1) and z = ray.oz -. o.%(2) in
  let ax = abs_float x and ay = abs_float y and az = abs_float z in
  let side = if ax >= ay && ax >= az then 0 else if ay >= az then 2 else 4 in
  let depth = if side = 0 then ax else if side = 2 then ay else az in
  let u = if side = 0 then y else x and v = if side = 4 then y else z in
  let is_back = (if side = 0 then x else if side = 2 then y else z) < 0. in
  let scale = 1. /. depth in
  Fan_face.meet ~any:true
    (Array.unsafe_get faces (side + Bool.to_int is_back))
    leaves ~u:(u *. scale) ~v:(v *. scale) ~pace:0. ~depth ray meeting

let some fan leaves ray meeting =
  match fan.kind with
  | Of_point -> some_to_point fan leaves ray meeting
  | Parallel | Of_eye -> some_parallel fan leaves ray meeting
