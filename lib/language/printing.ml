open Raylab_source
open Raylab_geometry
open Raylab_scene

let number = Number.to_exact_string

let vector { Vec3.x; y; z } =
  String.concat " " [ number x; number y; number z ]

let color { Color.r; g; b } =
  String.concat " " [ number r; number g; number b ]

let print_number ppf x = Format.pp_print_string ppf (number x)

let print_parameter ppf (_, parameter) =
  Format.fprintf ppf " %a" (Parameter.pp_with print_number) parameter

let print_light ppf (light : Light.t) =
  Format.fprintf ppf "%s %s %s" (Light.name light) (number light.intensity)
    (color light.color);
  List.iter (print_parameter ppf) (Light.parameters light);
  if light.is_unfading then Format.pp_print_string ppf " unfading"

let print_shape ppf shape =
  Format.pp_print_string ppf (Shape.name shape);
  List.iter (print_parameter ppf) (Shape.parameters shape)

let print_lens ppf { Lens.aperture; focus } =
  if aperture > 0. then Format.fprintf ppf "aperture %s@\n" (number aperture);
  Option.iter (fun f -> Format.fprintf ppf "focus %s@\n" (number f)) focus

(* What is not as it is by itself. *)
let print_film ppf { Film.samples; exposure; srgb } =
  if samples <> 1 then Format.fprintf ppf "samples %d@\n" samples;
  if exposure <> 1. then Format.fprintf ppf "exposure %s@\n" (number exposure);
  if srgb then Format.fprintf ppf "srgb@\n"

let print_plain name_of ppf (o : Object.t) =
  Format.fprintf ppf "%a %a%a" print_shape o.shape
    (Surface.pp_with ~name_of print_number)
    o.surface
    (Change.pp_with print_number)
    (Shape.modifiers o.shape)

let rec print_solid name_of primitives ppf : int Solid.tree -> unit = function
  | Member m -> print_plain name_of ppf primitives.(m)
  | Combined (operation, parts) ->
      Format.fprintf ppf "@[<v>@[<v 2>%s" (Solid.word operation);
      List.iter
        (fun part ->
          Format.fprintf ppf "@,%a" (print_solid name_of primitives) part)
        parts;
      Format.fprintf ppf "@]@,end@]"

let print_bare name_of ppf (o : Object.t) =
  (match o.shape with
  | Solid { tree; _ } -> print_solid name_of o.primitives ppf tree
  | _ -> print_plain name_of ppf o);
  if o.is_shadowless then Format.pp_print_string ppf " shadowless"

(* {1 Objects with parts that need a name}

   The names are known in a block of the object's own. *)

let pattern_of : Surface.t -> Surface.t Raylab_expression.Closed.t option =
  function
  | Varying { pattern; _ } when pattern.definitions <> [] -> Some pattern
  | _ -> None

let names_of (o : Object.t) =
  let parts = List.concat_map Surface.parts_to_name (Object.surfaces o) in
  let taken =
    List.concat_map Pattern_text.names (List.filter_map pattern_of parts)
  in
  (* longer than any name that begins so *)
  let rec prefix word =
    let starts name = String.starts_with ~prefix:word name in
    if List.exists starts taken then prefix (word ^ "_") else word
  in
  let prefix = prefix "surface_" in
  List.mapi (fun k part -> (part, prefix ^ string_of_int (k + 1))) parts

let begin_block ppf = Format.fprintf ppf "if (true)@\n"

(* A pattern has a block of its own around all that follows: what another one
   calls so as well may be something else. *)
let print_definition name_of ppf (part, name) =
  Option.iter
    (fun pattern ->
      begin_block ppf;
      Pattern_text.definitions ~name_of ppf pattern)
    (pattern_of part);
  Format.fprintf ppf "let %s = %a@\n" name
    (Surface.pp_form_with ~name_of print_number)
    part

let print_object comment ppf (o : Object.t) =
  let names = names_of o in
  let name_of part = List.assq_opt part names in
  let is_plain (part, _) = pattern_of part = None in
  let blocks = List.filter (fun named -> not (is_plain named)) names in
  let around = if List.exists is_plain names then 1 else 0 in
  if around = 1 then begin_block ppf;
  List.iter (print_definition name_of ppf) names;
  Format.fprintf ppf "%a%s@\n" (print_bare name_of) o (comment o.origin);
  for _ = 1 to around + List.length blocks do
    Format.fprintf ppf "end@\n"
  done

let print_background ppf : Background.t -> unit = function
  | Plain c -> Format.fprintf ppf "bcolor %s@\n" (color c)
  | Varying { pattern; _ } as background ->
      Pattern_text.definitions ~name_of:(fun _ -> None) ppf pattern;
      Format.fprintf ppf "bcolor %a@\n" Background.pp background

let print_viewpoint ppf { Viewpoint.eye; look_at; up; _ } =
  Format.fprintf ppf "eye %s@\nlookAt %s@\nup %s@\n" (vector eye)
    (vector look_at) (vector up)

let print_camera ppf (camera : Camera.t) =
  let { Camera.width; height; canvas_width; canvas_height; depth; _ } =
    camera
  in
  Format.fprintf ppf "imWidth %d@\nimHeight %d@\n" width height;
  (match camera.fov with
  | Some fov -> Format.fprintf ppf "fov %s@\n" (number fov)
  | None ->
      Format.fprintf ppf "canvWidth %s@\ncanvHeight %s@\ndepth %s@\n"
        (number canvas_width) (number canvas_height) (number depth));
  if Option.is_some camera.fov || Camera.is_placed camera then
    print_viewpoint ppf camera.viewpoint

(* [comment] says more of what stands in a line, by its origin *)
let print_with comment ppf (scene : Scene.t) =
  print_camera ppf scene.camera;
  print_background ppf scene.background;
  if not (Color.equal scene.ambient Color.black) then
    Format.fprintf ppf "ambient %s@\n" (color scene.ambient);
  Format.fprintf ppf "raydepth %d@\n" scene.ray_depth;
  print_lens ppf scene.lens;
  print_film ppf scene.film;
  if scene.lights <> [] then Format.fprintf ppf "lights@\n";
  List.iter
    (fun (light : Light.t) ->
      Format.fprintf ppf "%a%s@\n" print_light light (comment light.origin))
    scene.lights;
  Format.fprintf ppf "objects@\n";
  List.iter (print_object comment ppf) scene.objects

let print = print_with (fun _ -> "")

let expand ppf scene =
  let comment origin =
    match Scene.provenance scene origin with
    | None -> ""
    | Some place -> "  # " ^ Printable.text (Provenance.to_string place)
  in
  print_with comment ppf scene
