open Raylab_geometry
open Raylab_scene

type t = {
  name : string;
  title : string;
  spheres : int;
  random : bool;
  scene : unit -> Scene.t;
}

let width = 640
let height = 480

let camera =
  Camera.make ~width ~height ~canvas_width:4. ~canvas_height:3. ~depth:4.

let half_mirror color =
  Surface.(mixed [ (0.5, diffusive color); (0.5, reflective) ])

(* {1 Random spheres} *)

(* Six decimals: a million spheres are a file of 90 MB. *)
let rounded x = Float.round (x *. 1e6) /. 1e6
let between random low high = low +. Random.State.float random (high -. low)

(* Half diffusive, 40 % half mirrors, 10 % mirrors. *)
let random_surface random =
  let kind = Random.State.int random 10 in
  let channel () = rounded (between random 0.2 1.) in
  let r = channel () in
  let g = channel () in
  let b = channel () in
  let color = Color.make r g b in
  if kind < 5 then Surface.diffusive color
  else if kind < 9 then half_mirror color
  else Surface.reflective

let floor_height = -1.

(* The spheres fill the same part of the same box at every [n], so the picture
   goes from a few things on a floor to a dense cloud. *)
let random_sphere random ~n =
  let typical = 1.2 /. Float.cbrt (float_of_int n) in
  let radius = rounded (typical *. between random 0.5 1.5) in
  let x = rounded (between random (-3.5) 3.5) in
  let y = rounded (between random (floor_height +. radius) 2.) in
  let z = rounded (between random 2. 10.) in
  let surface = random_surface random in
  Object.make (Shape.sphere ~centre:(Vec3.make x y z) ~radius) surface

let floor =
  Object.make
    (Shape.plane
       ~point:(Vec3.make 0. floor_height 0.)
       ~normal:(Vec3.make 0. 1. 0.))
    (half_mirror (Color.make 0.8 0.8 0.8))

let sun =
  Light.directional ~intensity:0.7 ~color:Color.white
    ~direction:(Vec3.make 1. (-2.) 1.5)

let bulb position =
  Light.spherical ~intensity:20. ~color:(Color.make 1. 0.9 0.8) ~position

let random_scene n () =
  let random = Random.State.make [| n |] in
  let spheres = List.init n (fun _ -> random_sphere random ~n) in
  Scene.make camera ~ray_depth:5 ~background:(Color.make 0.35 0.5 0.75)
    ~lights:[ sun; bulb (Vec3.make (-3.) 5. 0.) ]
    ~objects:(floor :: spheres)

let random (name, title, spheres) =
  { name; title; spheres; random = true; scene = random_scene spheres }

(* {1 The mirror room} *)

let wall ~point ~normal surface =
  Object.make (Shape.plane ~point ~normal) surface

(* A closed room, two walls of which face each other and the eye. *)
let walls =
  let open Vec3 in
  let paint r g b = Surface.diffusive (Color.make r g b) in
  let mirror =
    Surface.mixed
      [
        (0.1, Surface.diffusive (Color.make 0.6 0.8 0.7));
        (0.9, Surface.reflective);
      ]
  in
  [
    wall ~point:(make 0. (-2.) 0.) ~normal:(make 0. 1. 0.) (paint 0.7 0.6 0.5);
    wall ~point:(make 0. 3. 0.) ~normal:(make 0. (-1.) 0.) (paint 0.8 0.8 0.8);
    wall ~point:(make (-4.) 0. 0.) ~normal:(make 1. 0. 0.) mirror;
    wall ~point:(make 4. 0. 0.) ~normal:(make (-1.) 0. 0.) mirror;
    wall ~point:(make 0. 0. 9.) ~normal:(make 0. 0. (-1.)) mirror;
    wall ~point:(make 0. 0. (-6.)) ~normal:(make 0. 0. 1.) mirror;
  ]

let room_spheres = 24

let room_sphere k =
  let column = float_of_int (k mod 6) and row = float_of_int (k / 6) in
  let centre =
    Vec3.make
      ((1.3 *. column) -. 3.25)
      (if k mod 2 = 0 then -1.4 else 0.6)
      ((2. *. row) +. 1.)
  in
  let surface =
    if k mod 3 = 0 then half_mirror (Color.make 0.9 0.5 0.2)
    else Surface.reflective
  in
  Object.make (Shape.sphere ~centre ~radius:0.6) surface

let mirror_room () =
  Scene.make camera ~ray_depth:30
    ~lights:[ bulb (Vec3.make 0. 2.5 3.); bulb (Vec3.make (-2.) 2. (-2.)) ]
    ~objects:(walls @ List.init room_spheres room_sphere)

(* {1 The sphereflake} *)

(* The gallery's scene, in a picture of the size of the others: wider, since it
   is square. *)
let sphereflake () =
  match Raylab_language.Scene_file.load Place.sphereflake with
  | Error _ -> failwith "the sphereflake cannot be read"
  | Ok scene ->
      let { Camera.canvas_height; depth; _ } = scene.camera in
      let canvas_width = canvas_height *. 4. /. 3. in
      Scene.with_camera
        (Camera.make ~width ~height ~canvas_width ~canvas_height ~depth)
        scene

(* {1 Meshes} *)

let mesh_name name = name ^ ".obj"

let mesh_scene name triangles () =
  let mesh = Ruffle.mesh ~name:(mesh_name name) ~triangles in
  let ring =
    Object.make (Mesh mesh) (Surface.diffusive (Color.make 0.9 0.5 0.3))
  in
  Scene.make camera ~ray_depth:5 ~background:(Color.make 0.35 0.5 0.75)
    ~lights:[ sun; bulb (Vec3.make (-3.) 5. 0.) ]
    ~objects:[ floor; ring ]

let mesh (name, title, triangles) =
  {
    name;
    title;
    spheres = triangles;
    random = false;
    scene = mesh_scene name triangles;
  }

let meshes { Scene.objects; _ } =
  List.filter_map
    (fun (o : Object.t) ->
      match o.shape with Mesh mesh -> Some mesh | _ -> None)
    objects

(* {1 All} *)

let million = "1000000"

let all =
  List.map random
    [
      ("10", "10 spheres", 10);
      ("100", "100 spheres", 100);
      ("1000", "1,000 spheres", 1_000);
      ("10000", "10,000 spheres", 10_000);
      ("100000", "100,000 spheres", 100_000);
      (million, "1,000,000 spheres", 1_000_000);
    ]
  @ [
      {
        name = "sphereflake";
        title = "sphereflake";
        spheres = 7381;
        random = false;
        scene = sphereflake;
      };
      {
        name = "mirror-room";
        title = "mirror room";
        spheres = room_spheres;
        random = false;
        scene = mirror_room;
      };
    ]
  @ List.map mesh
      [
        ("mesh-1000", "mesh, 1,000 triangles", 1_000);
        ("mesh-100000", "mesh, 100,000 triangles", 100_000);
        ("mesh-1000000", "mesh, 1,000,000 triangles", 1_000_000);
      ]

let find name = List.find_opt (fun scene -> scene.name = name) all
