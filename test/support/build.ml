open Raylab_geometry
open Raylab_scene

let v = Vec3.make
let dir x y z = Direction.of_vec3_exn (v x y z)
let ray origin d = Ray.make ~origin ~direction:(Direction.of_vec3_exn d)
let rgb = Color.make
let grey g = rgb g g g

let camera ?(width = 1) ?(height = 1) ?(canvas_width = 2.)
    ?(canvas_height = 2.) ?(depth = 1.) () =
  Camera.make ~width ~height ~canvas_width ~canvas_height ~depth

let sphere ?line centre radius =
  Object.make ?line (Shape.sphere ~centre ~radius)

let plane ?line point normal = Object.make ?line (Shape.plane ~point ~normal)
