open Raylab_source

type t = {
  camera : Camera.t;
  lens : Lens.t;
  film : Film.t;
  background : Background.t;
  ambient : Color.t;
  ray_depth : int;
  lights : Light.t list;
  objects : Object.t list;
  files : Files.t;
}

let default_ray_depth = 4
let max_ray_depth = 1_000_000
let require_ambient = Color.require "the ambient light"

let require_ray_depth ray_depth =
  if ray_depth < 0 || ray_depth > max_ray_depth then
    invalid_arg
      (Printf.sprintf "the ray depth must be from 0 to %d, not %d"
         max_ray_depth ray_depth)

let make ?(lens = Lens.pinhole) ?(film = Film.default)
    ?(background = Color.black) ?(ambient = Color.black)
    ?(ray_depth = default_ray_depth) ?(lights = []) ?(objects = [])
    ?(files = Files.none) camera =
  let background = Background.plain background in
  require_ambient ambient;
  require_ray_depth ray_depth;
  {
    camera;
    lens;
    film;
    background;
    ambient;
    ray_depth;
    lights;
    objects;
    files;
  }

let provenance scene = Provenance.make scene.files
let with_camera camera scene = { scene with camera }
let with_lens lens scene = { scene with lens }
let with_film film scene = { scene with film }
let with_sky background scene = { scene with background }
let with_background color = with_sky (Background.plain color)

let with_ambient ambient scene =
  require_ambient ambient;
  { scene with ambient }

let with_ray_depth ray_depth scene =
  require_ray_depth ray_depth;
  { scene with ray_depth }

let with_lights lights scene = { scene with lights }
let with_objects objects scene = { scene with objects }
let without_places scene = { scene with files = Files.none }

let greyscale scene =
  let grey c = Grey.to_color (Grey.of_color c) in
  let grey_object = Object.map_surfaces Surface.greyscale in
  {
    scene with
    background = Background.greyscale scene.background;
    ambient = grey scene.ambient;
    lights = List.map (Light.map_color grey) scene.lights;
    objects = List.map grey_object scene.objects;
  }

let findings scene =
  let some_surface holds =
    let holds_at_once surface = holds (Surface.lobes surface) in
    let holds surface =
      if Surface.varies surface then
        List.exists holds_at_once (Surface.simple surface)
      else holds_at_once surface
    in
    List.exists (fun o -> List.exists holds (Object.surfaces o)) scene.objects
  in
  let needs_light { Lobes.albedo; _ } = not (Color.equal albedo Color.black)
  and mirrors { Lobes.mirror; _ } = not (Color.equal mirror Color.black) in
  let of_all text = { Warning.text; about = [] } in
  List.filter_map
    (fun (holds, text) -> if holds () then Some (of_all text) else None)
    [
      ( (fun () -> scene.objects = []),
        "there is no object: the picture is all background" );
      ( (fun () -> scene.ray_depth = 0),
        "raydepth is 0: the picture is all background" );
      ( (fun () ->
          scene.lights = []
          && Color.equal scene.ambient Color.black
          && some_surface needs_light),
        "there is no light: diffusive surfaces are black" );
      ( (fun () -> scene.ray_depth = 1 && some_surface mirrors),
        "raydepth is 1: mirrors show nothing but the background" );
      ( (fun () -> Lens.is_open scene.lens && scene.film.samples = 1),
        "samples is 1: whatever the aperture, everything is sharp; say \
         samples 64 or so" );
    ]
  @ Proportions.warnings scene.camera
  @ Byte_colors.warnings ~background:scene.background ~ambient:scene.ambient
      scene.lights scene.objects
  @ Glasses.warnings ~ray_depth:scene.ray_depth scene.objects
  @ Kept_in.warnings scene.camera scene.lights scene.objects
  @ Twins.warnings scene.objects

let warnings scene =
  List.map (Warning.to_string (provenance scene)) (findings scene)

let equal a b =
  Camera.equal a.camera b.camera
  && Lens.equal a.lens b.lens && Film.equal a.film b.film
  && Background.equal a.background b.background
  && Color.equal a.ambient b.ambient
  && a.ray_depth = b.ray_depth
  && List.equal Light.equal a.lights b.lights
  && List.equal Object.equal a.objects b.objects

let shown_objects = 10

let pp ppf scene =
  Format.fprintf ppf "@[<v>scene of %d x %d pixels, %a" scene.camera.width
    scene.camera.height Camera.pp_view scene.camera;
  if Lens.is_open scene.lens then Format.fprintf ppf "@,%a" Lens.pp scene.lens;
  if not (Film.equal scene.film Film.default) then
    Format.fprintf ppf "@,%a" Film.pp scene.film;
  Format.fprintf ppf "@,background %a, ray depth %d" Background.pp
    scene.background scene.ray_depth;
  if not (Color.equal scene.ambient Color.black) then
    Format.fprintf ppf "@,ambient light %a" Color.pp scene.ambient;
  List.iteri
    (fun i light -> Format.fprintf ppf "@,light %d: %a" (i + 1) Light.pp light)
    scene.lights;
  List.iteri
    (fun i o ->
      if i < shown_objects then
        Format.fprintf ppf "@,object %d: %a" (i + 1) Object.pp o)
    scene.objects;
  let hidden = List.length scene.objects - shown_objects in
  if hidden > 0 then Format.fprintf ppf "@,and %d more objects" hidden;
  Format.fprintf ppf "@]"
