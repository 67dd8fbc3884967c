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

let equal (a : t) b = a = b
