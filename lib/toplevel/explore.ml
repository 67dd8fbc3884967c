open Raylab_scene
open Raylab_language
open Raylab_tracer
open Raylab_picture

let words =
  [
    ("help ()", "this list");
    ("scene ()", "the scene");
    ("load \"FILE\"", "takes another scene, from a file (~time:1. at time 1)");
    ("use SCENE", "takes another scene, made of OCaml values");
    ("why X Y", "why pixel (X, Y), counted from the top left, has its colour");
    ("pixel X Y", "why, in full");
    ("primary X Y", "the ray that looks through pixel (X, Y)");
    ("sample X Y K", "the ray of its sample K, counted from 1");
    ("trace RAY", "the colour that a ray brings");
    ("hit RAY", "what a ray hits first");
    ("explain RAY", "why it brings that colour");
    ("steps RAY", "what the tracer does for it, step by step: say next ()");
    ("next ()", "the next step");
    ("back ()", "the step before");
    ("render ()", "the picture of the scene");
    ("show ()", "the picture in a window, where a click explains a pixel");
    ("save \"FILE\"", "writes it as .bmp, .png or .ppm");
  ]

let building =
  {|
Scenes are built with vec, rgb, hsv, red ... white, directional, spherical,
spot, area, sphere, plane, box, cylinder, cone, torus, disc, triangle, quad,
mesh, diffusive, reflective, luminous, glossy, refractive, glass, mixed, tinted
and checker, as in a scene file, and varying "p ..."; put together by union,
intersection and difference; unfading is for lights; random, noise and
turbulence are numbers:

use (Scene.make camera
       ~lights:[ directional 1. white (vec 1. (-1.) 1.) ]
       ~objects:[ sphere (vec 0. 0. 6.) 1. (diffusive red) ])

Scene.with_ray_depth 6 (scene ()) is the scene with one thing changed. Others
are with_background, with_ambient, with_lights, with_objects, with_camera,
with_lens and with_film: Scene.with_film (Film.make ~samples:16 ()) (scene ())
is smooth.
looking (vec 3. 2. (-4.)) (vec 0. 0. 0.) camera is a camera elsewhere.|}

let help () =
  List.iter (fun (word, line) -> Format.printf "%-14s%s@." word line) words;
  Format.printf "%s@." building

(* {1 The scene} *)

let scene = Session.scene

let use scene =
  Session.use scene;
  Console.warnings (Scene.warnings scene)

let load ?time path =
  let reading = Session.load ?time path in
  (match reading.Scene_file.scene with
  | Ok scene -> Console.contents path scene
  | Error errors -> Console.errors errors);
  Console.warnings ~path (Scene_file.warnings reading)

(* {1 One ray} *)

let check_pixel x y =
  let { Camera.width; height; _ } = (scene ()).camera in
  if x < 0 || x >= width || y < 0 || y >= height then
    invalid_arg
      (Printf.sprintf
         "there is no pixel (%d, %d): x goes from 0 to %d, y from 0 to %d" x y
         (width - 1) (height - 1))

let pixel x y =
  check_pixel x y;
  Explain.pixel (Session.trace ()) ~x ~y

let why x y = Console.summary (pixel x y)

let primary x y =
  check_pixel x y;
  Sample_ray.make (scene ()) ~x ~y 0

let sample x y k =
  check_pixel x y;
  let { Scene.film; _ } = scene () in
  if k < 1 || k > film.samples then
    invalid_arg
      (Printf.sprintf "there is no sample %d: they go from 1 to %d" k
         film.samples);
  Sample_ray.make (scene ()) ~x ~y (k - 1)

let trace ray = Tracer.color (Session.trace ()) ray
let hit ray = Tracer.nearest_hit (Session.trace ()) ray
let explain ray = Explain.ray (Session.trace ()) ray

(* {1 Step by step} *)

let steps ray =
  let events = Explain.steps (Session.trace ()) ray in
  Session.set_walk (Walk.start events);
  events

let go way nowhere =
  match Session.walk () with
  | None -> invalid_arg "there are no steps yet: say steps (primary X Y) first"
  | Some walk -> (
      match way walk with
      | None -> invalid_arg nowhere
      | Some (event, walk) ->
          Session.set_walk walk;
          event)

let next () = go Walk.next "that was the last step; back () goes back"
let back () = go Walk.back "there is no step before; next () goes on"

(* {1 The picture} *)

let render () = Native.picture (scene ())

let show () =
  Native.show ?file:(Session.file ()) ~time:(Session.time ()) (scene ())

let or_sys_error = function
  | Ok value -> value
  | Error message -> raise (Sys_error message)

let save path =
  match Picture_file.format_of_path path with
  | Error message -> invalid_arg message
  | Ok format ->
      let { Camera.width; height; _ } = (scene ()).camera in
      or_sys_error (Picture_file.check_size format ~width ~height);
      or_sys_error (Picture_file.check format ~path ~width ~height);
      let outcome =
        or_sys_error (Picture_file.save format ~path (render ()))
      in
      Format.printf "%s@."
        (Raylab_source.Printable.text (Atomic_file.wrote ~path outcome))
