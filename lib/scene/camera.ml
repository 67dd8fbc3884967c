open Raylab_geometry
open Raylab_expression

type t = {
  width : int;
  height : int;
  fov : float option;
  canvas_width : float;
  canvas_height : float;
  depth : float;
  viewpoint : Viewpoint.t;
}

let max_size = 0x7fff_ffff

let require_pixels name n =
  if n < 1 || n > max_size then
    invalid_arg
      (Printf.sprintf "%s must be from 1 to %d, not %d" name max_size n)

let make_in viewpoint fov ~width ~height ~canvas_width ~canvas_height ~depth =
  require_pixels "the picture's width" width;
  require_pixels "the picture's height" height;
  Number.require Positive "the canvas's width" canvas_width;
  Number.require Positive "the canvas's height" canvas_height;
  Number.require Positive "the depth" depth;
  { width; height; fov; canvas_width; canvas_height; depth; viewpoint }

let make ~width ~height ~canvas_width ~canvas_height ~depth =
  Number.require Positive "the depth" depth;
  make_in
    (Viewpoint.before_origin depth)
    None ~width ~height ~canvas_width ~canvas_height ~depth

let of_fov ~width ~height ~fov viewpoint =
  if not (fov > 0. && fov < 180.) then
    invalid_arg
      (Printf.sprintf "the angle of view (%g) must be between 0 and 180" fov);
  require_pixels "the picture's width" width;
  let depth = Viewpoint.distance viewpoint in
  let canvas_width = 2. *. depth *. Degrees.tan (fov /. 2.) in
  let canvas_height =
    canvas_width *. (float_of_int height /. float_of_int width)
  in
  make_in viewpoint (Some fov) ~width ~height ~canvas_width ~canvas_height
    ~depth

let with_size ~width ~height camera =
  let { fov; canvas_width; canvas_height; depth; viewpoint; _ } = camera in
  match fov with
  | Some fov -> of_fov ~width ~height ~fov viewpoint
  | None ->
      make_in viewpoint None ~width ~height ~canvas_width ~canvas_height ~depth

let with_viewpoint viewpoint camera =
  match camera with
  | { width; height; fov = Some fov; _ } ->
      of_fov ~width ~height ~fov viewpoint
  | { fov = None; _ } -> { camera with viewpoint }

let is_placed { viewpoint; depth; _ } =
  not (Viewpoint.equal viewpoint (Viewpoint.before_origin depth))

let eye camera = camera.viewpoint.eye

(* The point of the canvas that is [x] to the right of its middle and [y]
   above. *)
let on_canvas { viewpoint; depth; _ } x y =
  Vec3.add viewpoint.eye (Viewpoint.of_frame viewpoint (Vec3.make x y depth))

let corners ({ canvas_width; canvas_height; _ } as camera) =
  let x = canvas_width /. 2. and y = canvas_height /. 2. in
  let at = on_canvas camera in
  (at (-.x) (-.y), at x (-.y), at x y, at (-.x) y)

let scale camera =
  Float.min camera.depth (Float.min camera.canvas_width camera.canvas_height)

(* [along extent count k] is where the place [k] of [0 ... count] lies on a line
   of length [extent], if its middle is at 0. *)
let[@inline] along extent count k =
  (-.extent /. 2.) +. (extent *. k /. float_of_int count)

let z_axis = Direction.of_vec3_exn (Vec3.make 0. 0. 1.)

(* Turns a direction of the viewpoint's frame into one of the scene's. *)
let[@inline] set_direction { Viewpoint.right; above; forward; _ } ray x y z =
  let r = (right :> Vec3.t)
  and u = (above :> Vec3.t)
  and f = (forward :> Vec3.t) in
  Raw_ray.set_direction ray
    ((x *. r.x) +. (y *. u.x) +. (z *. f.x))
    ((x *. r.y) +. (y *. u.y) +. (z *. f.y))
    ((x *. r.z) +. (y *. u.z) +. (z *. f.z))

(* Makes [ray] the one through the point of the canvas that is [across] to the
   right of its middle and [up] above. *)
let[@inline] aim_at { depth; viewpoint; _ } across up (ray : Raw_ray.t) =
  let { Viewpoint.eye; _ } = viewpoint in
  Raw_ray.set_origin ray eye.x eye.y eye.z;
  ray.reach <- infinity;
  let squared = (across *. across) +. (up *. up) +. (depth *. depth) in
  if squared > 1e-280 && squared < 1e280 then
    let scale = 1. /. sqrt squared in
    set_direction viewpoint ray (across *. scale) (up *. scale) (depth *. scale)
  else
    (* beyond what can be squared *)
    let direction = Direction.of_vec3_or z_axis (Vec3.make across up depth) in
    let { Vec3.x; y; z } = (direction :> Vec3.t) in
    set_direction viewpoint ray x y z

let[@inline] across { width; canvas_width; _ } x dx =
  along canvas_width width (float_of_int x +. dx)

let[@inline] up { height; canvas_height; _ } y dy =
  along canvas_height height (float_of_int (height - 1 - y) +. (1. -. dy))

let aim camera ~x ~y ~dx ~dy ray =
  aim_at camera (across camera x dx) (up camera y dy) ray

(* {1 Centres} *)

type centres = { columns : float array; rows : float array }

let no_centres = { columns = [||]; rows = [||] }
let most_kept = 0x10000

let centres camera =
  let kept count = Int.min count most_kept in
  {
    columns = Array.init (kept camera.width) (fun x -> across camera x 0.5);
    rows = Array.init (kept camera.height) (fun y -> up camera y 0.5);
  }

let[@inline] aim_at_centre camera { columns; rows } ~x ~y ray =
  if x >= 0 && x < Array.length columns && y >= 0 && y < Array.length rows then
    aim_at camera (Array.unsafe_get columns x) (Array.unsafe_get rows y) ray
  else aim camera ~x ~y ~dx:0.5 ~dy:0.5 ray

let ray_through camera ~x ~y ~dx ~dy =
  let ray = Raw_ray.create () in
  aim camera ~x ~y ~dx ~dy ray;
  Ray.of_raw ray

let primary_ray = ray_through ~dx:0.5 ~dy:0.5

let primary_rays camera =
  Seq.concat_map
    (fun y -> Seq.init camera.width (fun x -> primary_ray camera ~x ~y))
    (Seq.init camera.height Fun.id)

let fan { canvas_width; canvas_height; depth; viewpoint; _ } =
  let { Viewpoint.eye; right; above; forward; _ } = viewpoint in
  let width = canvas_width /. depth and height = canvas_height /. depth in
  Fan.Eye { eye; right; above; forward; width; height }

(* {1 From space to the picture} *)

(* Homogeneous coordinates on the canvas: the place (x / w, y / w). Points on a
   line in space are on a line here, and a direction is the point where lines
   along it vanish. *)
type homogeneous = { x : float; y : float; w : float }

let homogeneous { depth; viewpoint; _ } v =
  let { Vec3.x; y; z } = Viewpoint.to_frame viewpoint v in
  { x = x *. depth; y = y *. depth; w = z }

let of_point camera p = homogeneous camera (Vec3.sub p (eye camera))

let of_direction camera (d : Direction.t) =
  homogeneous camera (Vec3.scale camera.depth (d :> Vec3.t))

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

let pp_view ppf ({ canvas_width; canvas_height; depth; _ } as camera) =
  (match camera.fov with
  | Some fov -> Format.fprintf ppf "fov %a" Number.pp fov
  | None ->
      Format.fprintf ppf "canvas %a x %a, depth %a" Number.pp canvas_width
        Number.pp canvas_height Number.pp depth);
  if is_placed camera then
    Format.fprintf ppf "@,%a" Viewpoint.pp camera.viewpoint
