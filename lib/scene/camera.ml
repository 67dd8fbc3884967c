open Raylab_geometry

type t = {
  width : int;
  height : int;
  canvas_width : float;
  canvas_height : float;
  depth : float;
}

let max_size = 0x7fff_ffff

let require_pixels name n =
  if n < 1 || n > max_size then
    invalid_arg
      (Printf.sprintf "%s must be from 1 to %d, not %d" name max_size n)

let make ~width ~height ~canvas_width ~canvas_height ~depth =
  require_pixels "the picture's width" width;
  require_pixels "the picture's height" height;
  Number.require Positive "the canvas's width" canvas_width;
  Number.require Positive "the canvas's height" canvas_height;
  Number.require Positive "the depth" depth;
  { width; height; canvas_width; canvas_height; depth }

let with_size ~width ~height { canvas_width; canvas_height; depth; _ } =
  make ~width ~height ~canvas_width ~canvas_height ~depth

let eye camera = Vec3.make 0. 0. (-.camera.depth)

let canvas { canvas_width = w; canvas_height = h; _ } =
  (Vec3.make (w /. -2.) (h /. -2.) 0., Vec3.make (w /. 2.) (h /. 2.) 0.)

let scale camera =
  Float.min camera.depth (Float.min camera.canvas_width camera.canvas_height)

(* [along extent count k] is where the centre of the k-th of [count] equal parts
   of a line lies, if the line has length [extent] and its middle is at 0. *)
let[@inline] along extent count k =
  (-.extent /. 2.) +. (extent *. (float_of_int k +. 0.5) /. float_of_int count)

let z_axis = Direction.of_vec3_exn (Vec3.make 0. 0. 1.)

let aim camera ~x ~y (ray : Raw_ray.t) =
  let from_bottom = camera.height - 1 - y in
  let dx = along camera.canvas_width camera.width x
  and dy = along camera.canvas_height camera.height from_bottom
  and dz = camera.depth in
  Raw_ray.set_origin ray 0. 0. (-.dz);
  ray.reach <- infinity;
  let squared = (dx *. dx) +. (dy *. dy) +. (dz *. dz) in
  if squared > 1e-280 && squared < 1e280 then
    let scale = 1. /. sqrt squared in
    Raw_ray.set_direction ray (dx *. scale) (dy *. scale) (dz *. scale)
  else
    (* beyond what can be squared *)
    let direction = Direction.of_vec3_or z_axis (Vec3.make dx dy dz) in
    let { Vec3.x; y; z } = (direction :> Vec3.t) in
    Raw_ray.set_direction ray x y z

let primary_ray camera ~x ~y =
  let ray = Raw_ray.create () in
  aim camera ~x ~y ray;
  Ray.of_raw ray

let primary_rays camera =
  Seq.concat_map
    (fun y -> Seq.init camera.width (fun x -> primary_ray camera ~x ~y))
    (Seq.init camera.height Fun.id)

(* {1 From space to the picture} *)

(* Homogeneous coordinates on the canvas: the place (x / w, y / w). Points on a
   line in space are on a line here, and a direction is the point where lines
   along it vanish. *)
type homogeneous = { x : float; y : float; w : float }

let of_point { depth; _ } { Vec3.x; y; z } =
  { x = x *. depth; y = y *. depth; w = z +. depth }

let of_direction { depth; _ } (d : Direction.t) =
  let { Vec3.x; y; z } = Vec3.scale depth (d :> Vec3.t) in
  { x = x *. depth; y = y *. depth; w = z }

(* what is closer to the plane of the eye than this is not shown *)
let near camera = 1e-6 *. camera.depth

let place camera { x; y; w } =
  let across = x /. w /. camera.canvas_width
  and up = y /. w /. camera.canvas_height in
  ( (0.5 +. across) *. float_of_int camera.width,
    (0.5 -. up) *. float_of_int camera.height )

let is_finite (x, y) = Float.is_finite x && Float.is_finite y

let project camera point =
  let h = of_point camera point in
  if h.w < near camera then None
  else
    let p = place camera h in
    if is_finite p then Some p else None

let between a b s =
  let mix a b = ((1. -. s) *. a) +. (s *. b) in
  { x = mix a.x b.x; y = mix a.y b.y; w = mix a.w b.w }

let project_ray camera ray ~length =
  let a = of_point camera (Ray.origin ray)
  and b =
    if length = infinity then of_direction camera (Ray.direction ray)
    else of_point camera (Ray.at ray length)
  and near = near camera in
  let cut = between a b ((near -. a.w) /. (b.w -. a.w)) in
  let segment a b =
    let a = place camera a and b = place camera b in
    if is_finite a && is_finite b then Some (a, b) else None
  in
  match (a.w >= near, b.w >= near) with
  | true, true -> segment a b
  | true, false -> segment a cut
  | false, true -> segment cut b
  | false, false -> None

let equal (a : t) b = a = b
