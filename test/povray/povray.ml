open Raylab_geometry
open Raylab_scene

let version () =
  match Child.run "povray" [ "--version" ] with
  | Error _ -> None
  | Ok { output; _ } ->
      List.find_map
        (fun line ->
          try
            (* the version, then perhaps a point and the kind of build *)
            Scanf.sscanf line "POV-Ray %[0-9.]" (fun version ->
                Some
                  (String.concat "."
                     (List.filter (( <> ) "")
                        (String.split_on_char '.' version))))
          with Scanf.Scan_failure _ | End_of_file -> None)
        (String.split_on_char '\n' output)

(* {1 Writing a scene} *)

let number = Number.to_exact_string
let triple x y z = Printf.sprintf "<%s,%s,%s>" (number x) (number y) (number z)
let vector { Vec3.x; y; z } = triple x y z
let color { Color.r; g; b } = triple r g b

(* Far beyond everything, but well within POV-Ray's largest distance, 1e7. *)
let sun_distance = 1e6

(* f in the fall-off, as a part of the scene's lengths. *)
let fade = 1e-3

let write_camera channel (camera : Camera.t) =
  let { Camera.canvas_width; canvas_height; depth; viewpoint; _ } = camera in
  let along k (d : Direction.t) = vector (Vec3.scale k (d :> Vec3.t)) in
  Printf.fprintf channel
    "camera { location %s direction %s\n         right %s up %s }\n"
    (vector viewpoint.eye)
    (along depth viewpoint.forward)
    (along canvas_width viewpoint.right)
    (along canvas_height viewpoint.above)

let write_point channel scale (light : Light.t) position more =
  let power = Color.scale light.intensity light.color in
  let distance = fade *. scale in
  let near = 1. /. (2. *. distance *. distance) in
  let strength, fading =
    if light.is_unfading then (power, "")
    else
      ( Color.scale near power,
        Printf.sprintf "fade_distance %s fade_power 2" (number distance) )
  in
  Printf.fprintf channel "light_source { %s rgb %s %s %s }\n" (vector position)
    (color strength) fading more

let write_light channel camera (light : Light.t) =
  let scale = Camera.scale camera in
  let power = Color.scale light.intensity light.color in
  match light.source with
  | Directional direction ->
      let back = Vec3.scale (-.sun_distance *. scale) (direction :> Vec3.t) in
      Printf.fprintf channel
        "light_source { %s rgb %s parallel point_at <0,0,0> }\n" (vector back)
        (color power)
  | Spherical position -> write_point channel scale light position ""
  | Spot { position; target; inner; outer; _ } ->
      Printf.sprintf "spotlight point_at %s radius %s falloff %s tightness 0"
        (vector target) (number inner) (number outer)
      |> write_point channel scale light position
  | Area { corner; edge; other; count } ->
      let shrunk = float_of_int (count - 1) /. float_of_int count in
      let inner = Vec3.scale shrunk in
      let middle = Vec3.(add corner (scale 0.5 (add edge other))) in
      Printf.sprintf "area_light %s,%s,%d,%d area_illumination on"
        (vector (inner edge))
        (vector (inner other))
        count count
      |> write_point channel scale light middle

(* Grey, and one: what POV-Ray's Phong highlights can be. *)
let highlight { Lobes.sharpness; shine = { r; g; b } } =
  if r <> g || g <> b then invalid_arg "POV-Ray: a coloured highlight";
  Printf.sprintf " phong %s phong_size %s" (number r) (number sharpness)

(* All of one kind and one colour; shadows are weakened as here. *)
let write_clear channel { Lobes.plain; fresnel; glass; _ } =
  let is_glass = not (Color.equal fresnel Color.black) in
  let { Color.r; g; b } = if is_glass then glass else plain in
  Printf.fprintf channel " pigment{rgbf<%s,%s,%s,1>}finish{diffuse 0%s}}\n"
    (number r) (number g) (number b)
    (if is_glass then " reflection{1 fresnel} conserve_energy" else "")

let write_plain channel { Lobes.emission; albedo; mirror; highlights; _ } =
  let is_black = Color.equal Color.black in
  let reflection =
    if is_black mirror then ""
    else Printf.sprintf " reflection{rgb%s}" (color mirror)
  in
  let finish pigment kind =
    Printf.fprintf channel " pigment{rgb%s}finish{%s%s%s}}\n" (color pigment)
      kind reflection
      (String.concat "" (List.map highlight highlights))
  in
  match (is_black emission, is_black albedo) with
  | true, true -> finish Color.black "diffuse 0"
  | true, false -> finish albedo "diffuse 1 ambient 1"
  | false, true -> finish emission "diffuse 0 emission 1"
  | false, false -> invalid_arg "POV-Ray: a luminous and diffusive surface"

let write_surface channel surface =
  let lobes = Surface.lobes surface in
  match lobes.refractions with
  | [] -> write_plain channel lobes
  | [ refraction ]
    when Lobes.equal lobes { Lobes.none with refractions = [ refraction ] } ->
      write_clear channel refraction
  | _ -> invalid_arg "POV-Ray: a mix with what refracts"

(* Of a solid as a whole: all its primitives are of one index. *)
let interior surface =
  match (Surface.lobes surface).refractions with
  | { index; _ } :: _ -> Printf.sprintf " interior{ior %s}" (number index)
  | [] -> ""

let matrix (a : Affine.t) =
  Printf.sprintf " matrix<%s>"
    (String.concat ","
       (List.map number
          [ a.xx; a.yx; a.zx; a.xy; a.yy; a.zy; a.xz; a.yz; a.zz ]
       @ List.map number [ a.x; a.y; a.z ]))

(* Its torus lies around the y axis; the matrix has where x, y and z go, and the
   origin. *)
let torus { Torus.centre; axis; ring; tube } =
  let w = (axis :> Vec3.t) in
  let aside =
    if abs_float w.x < 0.6 then Vec3.make 1. 0. 0. else Vec3.make 0. 0. 1.
  in
  let u = (Direction.of_vec3_exn (Vec3.cross w aside) :> Vec3.t) in
  let rows = [ u; w; Vec3.cross u w; centre ] in
  let numbers { Vec3.x; y; z } = List.map number [ x; y; z ] in
  Printf.sprintf "torus{%s,%s sturm matrix<%s>" (number ring) (number tube)
    (String.concat "," (List.concat_map numbers rows))

let quad corners =
  let count = List.length corners + 1 in
  Printf.sprintf "polygon{%d,%s,%s" count
    (String.concat "," (List.map vector corners))
    (vector (List.hd corners))

(* A smooth triangle of POV-Ray has a normal at each corner. *)
let mesh mesh =
  let { Facets.points; normals; corners; corner_normals; _ } =
    Mesh.facets mesh
  in
  let at numbers k =
    triple numbers.(3 * k) numbers.((3 * k) + 1) numbers.((3 * k) + 2)
  in
  let corner k =
    let point = at points corners.(k) in
    if Mesh.is_smooth mesh then point ^ "," ^ at normals corner_normals.(k)
    else point
  and word = if Mesh.is_smooth mesh then "smooth_triangle" else "triangle" in
  let triangle t =
    Printf.sprintf "%s{%s}" word
      (String.concat "," (List.init 3 (fun k -> corner ((3 * t) + k))))
  in
  let all = List.init (Array.length corners / 3) triangle in
  Printf.sprintf "mesh{%s inside_vector<0.2,0.5,0.7>" (String.concat "\n" all)

(* Without the last bracket: the surface follows. *)
let rec shape : Shape.t -> string = function
  | Sphere sphere ->
      Printf.sprintf "sphere{%s,%s"
        (vector (Sphere.centre sphere))
        (number sphere.radius)
  | Plane { point; normal } ->
      let normal = (normal :> Vec3.t) in
      Printf.sprintf "plane{%s,%s" (vector normal)
        (number (Vec3.dot point normal))
  | Box { low; high } -> Printf.sprintf "box{%s,%s" (vector low) (vector high)
  | Cylinder c ->
      let { Frustum.a; b; radius_a; _ } = (c :> Frustum.t) in
      Printf.sprintf "cylinder{%s,%s,%s" (vector a) (vector b)
        (number radius_a)
  | Cone c ->
      let { Frustum.a; b; radius_a; radius_b; _ } = (c :> Frustum.t) in
      Printf.sprintf "cone{%s,%s,%s,%s" (vector a) (number radius_a) (vector b)
        (number radius_b)
  | Torus t -> torus t
  | Disc { centre; normal; radius } ->
      Printf.sprintf "disc{%s,%s,%s" (vector centre)
        (vector (normal :> Vec3.t))
        (number radius)
  | Triangle { a; b; c; _ } ->
      Printf.sprintf "triangle{%s,%s,%s" (vector a) (vector b) (vector c)
  | Quad q -> quad (Quad.corners q)
  | Mesh m -> mesh m
  | Placed { own; out; _ } -> shape own ^ matrix out
  | Solid _ -> invalid_arg "POV-Ray: a solid without surfaces"

let rec write_solid channel primitives after : int Solid.tree -> unit =
  function
  | Member m ->
      output_string channel (shape primitives.(m).Object.shape);
      write_surface channel primitives.(m).surface
  | Combined (operation, parts) ->
      Printf.fprintf channel "%s{\n" (Solid.word operation);
      List.iter (write_solid channel primitives "") parts;
      Printf.fprintf channel "%s}\n" after

let write_object channel (o : Object.t) =
  let shadow = if o.is_shadowless then " no_shadow" else "" in
  match o.shape with
  | Solid { tree; _ } ->
      let after = shadow ^ interior o.surface in
      write_solid channel o.primitives after tree
  | own ->
      output_string channel (shape own);
      output_string channel (shadow ^ interior o.surface);
      write_surface channel o.surface

(* POV-Ray counts the primary ray as level 1, as raylab does, and allows at
   most 256. It would also end a chain that cannot change a pixel any more. *)
let write channel (scene : Scene.t) =
  Printf.fprintf channel
    "#version 3.7;\n\
     global_settings { assumed_gamma 1 max_trace_level %d adc_bailout 0\n\
    \                  ambient_light rgb %s }\n\
     #default { finish { ambient 0 } }\n\
     background { rgb %s }\n"
    (Int.max 1 (Int.min 256 scene.ray_depth))
    (color scene.ambient)
    (color (Background.at scene.background Vec3.zero));
  write_camera channel scene.camera;
  List.iter (write_light channel scene.camera) scene.lights;
  List.iter (write_object channel) scene.objects

let empty = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"

(* {1 Running} *)

type t = {
  parse : Child.clock;
  bounding : Child.clock;
  trace : Child.clock;
  process : Child.clock;
  rays : int;
  shadow_rays : int;
}

let scan line format result =
  try Some (Scanf.sscanf line format result)
  with Scanf.Scan_failure _ | End_of_file | Failure _ -> None

(* [Trace Time:  0 hours 0 minutes 1 seconds (1.234 seconds)] and on the next
   line [using 4 thread(s) with 4.321 CPU-seconds total]. *)
let rec time name = function
  | first :: (second :: _ as rest) -> (
      match
        scan first " %s Time: %_d hours %_d minutes %_d seconds (%f seconds)"
          (fun found wall -> (found, wall))
      with
      | Some (found, wall) when found = name ->
          scan second " using %_d thread(s) with %f CPU-seconds" (fun cpu ->
              { Child.wall; cpu })
      | _ -> time name rest)
  | _ -> None

let count name lines =
  let counted line =
    if String.starts_with ~prefix:name line then scan line "%_[^:]: %d" Fun.id
    else None
  in
  Option.value (List.find_map counted lines) ~default:0

let statistics ({ output; clock } : Child.outcome) =
  let lines = String.split_on_char '\n' output in
  match (time "Parse" lines, time "Bounding" lines, time "Trace" lines) with
  | Some parse, Some bounding, Some trace ->
      Ok
        {
          parse;
          bounding;
          trace;
          process = clock;
          rays = count "Rays" lines;
          shadow_rays = count "Shadow Ray Tests" lines;
        }
  | _ -> Error ("POV-Ray's statistics are not understood:\n" ^ output)

let least figure runs = Figures.minimum (List.map figure runs)

let overhead runs =
  least (fun run -> run.process.cpu) runs
  -. least (fun run -> run.trace.cpu) runs

let trace_by_difference ~overhead runs =
  least
    (fun { process; parse; bounding; _ } ->
      process.cpu -. parse.cpu -. bounding.cpu)
    runs
  -. overhead

let file_type file = if Filename.extension file = ".ppm" then "P" else "N"

(* POV-Ray may read and write only certain directories; its own current one is
   always among them. *)
let render ?picture ~threads ~width ~height path =
  let output =
    match picture with
    | None -> [ "Output_to_File=Off" ]
    | Some file ->
        [
          "Output_File_Type=" ^ file_type file;
          "Output_File_Name=" ^ file;
          "File_Gamma=1";
        ]
  in
  let arguments =
    [
      "Input_File_Name=" ^ Filename.basename path;
      Printf.sprintf "Width=%d" width;
      Printf.sprintf "Height=%d" height;
      Printf.sprintf "Work_Threads=%d" threads;
      "Antialias=Off";
      "Display=Off";
      "Verbose=Off";
    ]
    @ output
  in
  Result.bind
    (Child.run ~dir:(Filename.dirname path) "povray" arguments)
    statistics
