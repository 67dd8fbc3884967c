open Raylab_geometry
open Raylab_scene

let vec = Vec3.make

let ray origin direction =
  Ray.make ~origin ~direction:(Direction.of_vec3_exn direction)

let rgb = Color.make
let black = Color.black
let white = Color.white
let red = Color.red
let green = Color.green
let blue = Color.blue
let cyan = Color.cyan
let magenta = Color.magenta
let yellow = Color.yellow
let named name = List.assoc name Color.names
let grey = named "grey"
let orange = named "orange"
let brown = named "brown"
let pink = named "pink"
let purple = named "purple"
let gold = named "gold"
let silver = named "silver"

let hsv h s v =
  let { Vec3.x; y; z } = Raylab_expression.Hsv.color ~h ~s ~v in
  rgb x y z

let random = Raylab_expression.Hash.random
let noise { Vec3.x; y; z } = Raylab_expression.Noise.noise x y z

let turbulence { Vec3.x; y; z } octaves =
  Raylab_expression.Noise.turbulence x y z octaves

let directional intensity color direction =
  Light.directional ~intensity ~color ~direction

let spherical intensity color position =
  Light.spherical ~intensity ~color ~position

let spot intensity color position target inner outer =
  Light.spot ~intensity ~color (Beam.make_exn ~position ~target ~inner ~outer)

let area intensity color corner edge other count =
  Light.area ~intensity ~color (Pane.make ~corner ~edge ~other ~count)

let unfading = Light.unfading
let diffusive = Surface.diffusive
let reflective = Surface.reflective
let luminous = Surface.luminous
let glossy sharpness color = Surface.glossy ~sharpness color
let refractive index color = Surface.refractive ~index color
let glass index color = Surface.glass ~index color
let mixed = Surface.mixed
let tinted = Surface.tinted
let checker = Surface.checker

let varying text =
  let open Raylab_language in
  let scene =
    "imWidth 1 imHeight 1 canvWidth 1 canvHeight 1 depth 1\n\
     sphere 0 0 0 1 varying " ^ text
  in
  let sources = Raylab_source.Sources.make ~name:"varying" scene in
  match Scene_file.parse sources with
  | Ok { objects = [ { surface; _ } ]; _ } -> surface
  | Ok _ -> invalid_arg "varying: more than a surface"
  | Error errors ->
      let first = List.hd errors in
      invalid_arg (Printf.sprintf "varying: %s" first.Scene_error.message)

let sphere centre radius surface =
  Object.make (Shape.sphere ~centre ~radius) surface

let plane point normal surface =
  Object.make (Shape.plane ~point ~normal) surface

let box corner opposite surface =
  Object.make (Shape.box_between ~corner ~opposite) surface

let cylinder a b radius surface =
  Object.make (Shape.cylinder a b ~radius) surface

let cone a radius_a b radius_b surface =
  Object.make (Shape.cone a radius_a b radius_b) surface

let torus centre axis ring tube surface =
  Object.make (Shape.torus ~centre ~axis ~ring ~tube) surface

let disc centre normal radius surface =
  Object.make (Shape.disc ~centre ~normal ~radius) surface

let triangle a b c surface = Object.make (Shape.triangle a b c) surface

let quad corner edge other surface =
  Object.make (Shape.quad ~corner ~edge ~other) surface

let mesh ?(smooth = false) path surface =
  let open Raylab_mesh_file in
  match Mesh_file.format_of_name path with
  | None -> failwith (path ^ " is no name of a mesh: .obj, .ply or .stl")
  | Some format -> (
      let bytes = In_channel.with_open_bin path In_channel.input_all in
      match Mesh_file.read format bytes with
      | Error fault -> failwith (path ^ ": " ^ Fault.to_string fault)
      | Ok (facets, _) ->
          let model = Model.make ~name:path facets in
          Object.make (Mesh (Model.mesh model ~is_smooth:smooth)) surface)

let changed modifier = Object.transformed (Change.of_modifiers [ modifier ])
let scaled k = changed (Scaled k)
let stretched factors = changed (Stretched factors)

let rotated axis angle =
  let open Raylab_expression in
  let axis = Direction.of_vec3_exn axis in
  changed
    (Rotated { axis; angle; sin = Degrees.sin angle; cos = Degrees.cos angle })

let translated way = changed (Translated way)

let combined operation objects =
  let members = List.map (fun o -> Solid.Member o) objects in
  Object.solid (Combined (operation, members))

let union objects = combined Union objects
let intersection objects = combined Intersection objects
let difference objects = combined Difference objects
let shadowless = Object.shadowless

let camera =
  Camera.make ~width:640 ~height:480 ~canvas_width:4. ~canvas_height:3.
    ~depth:4.

let looking ?up eye look_at =
  Camera.with_viewpoint (Viewpoint.make_exn ?up ~look_at eye)

let fov fov { Camera.width; height; viewpoint; _ } =
  Camera.of_fov ~width ~height ~fov viewpoint

let empty = Scene.make camera
