open Raylab_geometry
open Raylab_source
open Raylab_scene

let v = Vec3.make
let dir x y z = Direction.of_vec3_exn (v x y z)
let ray origin d = Ray.make ~origin ~direction:(Direction.of_vec3_exn d)
let rgb = Color.make
let grey g = rgb g g g

let camera ?(width = 1) ?(height = 1) ?(canvas_width = 2.)
    ?(canvas_height = 2.) ?(depth = 1.) () =
  Camera.make ~width ~height ~canvas_width ~canvas_height ~depth

let lines = 100
let empty_lines = Lines.index (String.make (lines - 1) '\n')

let files =
  Files.none
  |> Files.add ~name:"test.scene" empty_lines
  |> Files.add ~name:"wood.scene" empty_lines

let at_line line = Origin.Literal (line - 1)
let at_line_of_wood line = Origin.Literal (lines + line - 1)
let place = Scene.provenance (Scene.make ~files (camera ()))

let sphere ?line centre radius =
  let origin = Option.map at_line line in
  Object.make ?origin (Shape.sphere ~centre ~radius)

let plane ?line point normal =
  let origin = Option.map at_line line in
  Object.make ?origin (Shape.plane ~point ~normal)
