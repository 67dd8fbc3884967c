open Raylab_geometry
open Raylab_expression
open Raylab_scene

let least_angle = 1.

(* [short d x] is [x], rounded to a thousandth of the power of ten in [d]. *)
let short d x =
  let digits = 3 - int_of_float (Float.floor (Float.log10 d)) in
  let digits = Int.max 0 (Int.min 300 digits) in
  float_of_string (Printf.sprintf "%.*f" digits x)

(* [viewpoint] with its eye elsewhere, or as it is where that cannot be. *)
let moved ({ Viewpoint.look_at; up; _ } as viewpoint) way =
  let { Vec3.x; y; z } = Vec3.add look_at way
  and short = short (Vec3.length way) in
  match
    Viewpoint.make ~look_at ~up (Vec3.make (short x) (short y) (short z))
  with
  | Ok moved -> moved
  | Error _ | (exception Invalid_argument _) -> viewpoint

let within low high x = Float.max low (Float.min high x)

let turn ~across ~down viewpoint =
  let { Viewpoint.eye; look_at; up; right; _ } = viewpoint in
  let way = Vec3.sub eye look_at and right = (right :> Vec3.t) in
  let up = (Direction.of_vec3_exn up :> Vec3.t) in
  let height = Vec3.dot way up in
  let level = Vec3.sub way (Vec3.scale height up) in
  let distance = Vec3.length way and width = Vec3.length level in
  if not (Float.is_finite distance && width > 0.) then viewpoint
  else
    let angle = Arc.atan2 width height in
    let angle =
      within
        (Float.min angle least_angle)
        (Float.max angle (180. -. least_angle))
        (angle -. (180. *. down))
    in
    let out = Vec3.scale (1. /. width) level and around = 180. *. across in
    let out =
      Vec3.sub
        (Vec3.scale (Degrees.cos around) out)
        (Vec3.scale (Degrees.sin around) right)
    in
    moved viewpoint
      (Vec3.add
         (Vec3.scale (distance *. Degrees.cos angle) up)
         (Vec3.scale (distance *. Degrees.sin angle) out))

let nearer factor ({ Viewpoint.eye; look_at; _ } as viewpoint) =
  moved viewpoint (Vec3.scale (1. /. factor) (Vec3.sub eye look_at))

let settings { Viewpoint.eye; look_at; up; _ } =
  let vector { Vec3.x; y; z } =
    String.concat " " (List.map Number.to_exact_string [ x; y; z ])
  in
  let setting word v = Printf.sprintf "%s %s" word (vector v) in
  String.concat "   "
    ([ setting "eye" eye; setting "lookAt" look_at ]
    @ if Vec3.equal up Viewpoint.default_up then [] else [ setting "up" up ])
