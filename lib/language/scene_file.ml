open Raylab_source
open Raylab_geometry
open Raylab_scene

let max_size = Loader.max_size

let too_large file =
  let reason = Printf.sprintf "the scene is larger than %d bytes" max_size in
  Error [ Scene_error.unreadable ~file reason ]

type reading = {
  sources : Sources.t;
  named : (Span.t * string) list;
  missing : string list;
  meshes : Mesh.t list;
  scene : (Scene.t, Scene_error.t list) result;
  noted : Warning.t list;
}

let unread scene =
  {
    sources = Sources.none;
    named = [];
    missing = [];
    meshes = [];
    scene;
    noted = [];
  }

(* A file that is not UTF-8, if there is one. *)
let foreign sources =
  let tell (file : Sources.file) =
    let told encoding =
      Scene_error.whole sources file
        (Printf.sprintf "the text is %s, and a scene is UTF-8" encoding)
        ~advice:"save it as UTF-8"
    in
    Option.map told (Encoding.foreign file.text)
  in
  List.find_map tell (Sources.files sources)

(* What nests has a limit, for which JavaScript's stack may still be small. *)
let too_deep sources =
  let main = Sources.file sources 0 in
  Scene_error.whole sources main
    "the scene is nested too deep for the stack that there is"
    ~advice:"nest blocks, brackets, calls and files less deep"

let read_all ?time access sources =
  if Sources.size sources > max_size then
    unread (too_large (Sources.name sources 0))
  else
    let { Loader.sources; named; missing; meshes; taken; unused; syntax } =
      try Loader.read access sources
      with Stack_overflow ->
        let syntax = Error [ too_deep sources ] in
        {
          Loader.sources;
          named = [];
          missing = [];
          meshes = [];
          taken = [];
          unused = [];
          syntax;
        }
    in
    let scene =
      match Result.bind syntax (Evaluate.scene ?time sources) with
      | Ok scene -> Ok scene
      | Error errors ->
          let foreign = Option.map (fun e -> [ e ]) (foreign sources) in
          Error (Option.value foreign ~default:errors)
      | exception Stack_overflow -> Error [ too_deep sources ]
    in
    let noted = Taken.warnings taken @ unused in
    { sources; named; missing; meshes; scene; noted }

let findings { scene; noted; _ } =
  noted @ Result.fold ~ok:Scene.findings ~error:(fun _ -> []) scene

let provenance { sources; _ } = Provenance.make (Sources.table sources)

let warnings reading =
  List.map (Warning.to_string (provenance reading)) (findings reading)

let parse ?time ?(access = Access.none) sources =
  (read_all ?time access sources).scene

let without_extension path =
  match String.lowercase_ascii (Filename.extension path) with
  | ".scene" | ".txt" -> Filename.remove_extension path
  | _ -> path

(* {1 Reading files} *)

let chunk_size = 1 lsl 16

(* The text, or [None] if it has more than [limit] bytes. By chunks, since the
   length of a pipe or a device is not known before; a folder's seems huge until
   one reads it. *)
let read_at_most limit channel =
  let length = try In_channel.length channel with Sys_error _ -> 0L in
  let is_too_large = length > Int64.of_int limit in
  let known = if is_too_large then 0 else Int64.to_int length in
  let text = Buffer.create (Int.max chunk_size known) in
  let chunk = Bytes.create chunk_size in
  let rec read () =
    match In_channel.input channel chunk 0 chunk_size with
    | 0 -> Some (Buffer.contents text)
    | count when is_too_large || Buffer.length text + count > limit -> None
    | count ->
        Buffer.add_subbytes text chunk 0 count;
        read ()
  in
  read ()

let read_text path =
  if path = "-" then (
    In_channel.set_binary_mode stdin true;
    read_at_most max_size stdin)
  else In_channel.with_open_bin path (read_at_most max_size)

let read_main path =
  let file = if path = "-" then "<standard input>" else path in
  match read_text path with
  | Some text -> Ok (Sources.make ~path ~name:file text)
  | None -> too_large file
  | exception Sys_error reason ->
      (* the system's message starts with the path, which the error names *)
      let prefix = path ^ ": " in
      let reason =
        if String.starts_with ~prefix reason then
          let n = String.length prefix in
          String.sub reason n (String.length reason - n)
        else reason
      in
      Error [ Scene_error.unreadable ~file reason ]

let no_access _ = Access.none

let read ?time ?(access = no_access) path =
  match read_main path with
  | Ok sources -> read_all ?time (access path) sources
  | Error _ as scene -> unread scene

let load ?time ?access path = (read ?time ?access path).scene

(* {1 Printing} *)

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

let print_plain ppf (o : Object.t) =
  Format.fprintf ppf "%a %a%a" print_shape o.shape
    (Surface.pp_with print_number)
    o.surface
    (Change.pp_with print_number)
    (Shape.modifiers o.shape)

let rec print_solid primitives ppf : int Solid.tree -> unit = function
  | Member m -> print_plain ppf primitives.(m)
  | Combined (operation, parts) ->
      Format.fprintf ppf "@[<v>@[<v 2>%s" (Solid.word operation);
      List.iter
        (fun part -> Format.fprintf ppf "@,%a" (print_solid primitives) part)
        parts;
      Format.fprintf ppf "@]@,end@]"

let print_object ppf (o : Object.t) =
  (match o.shape with
  | Solid { tree; _ } -> print_solid o.primitives ppf tree
  | _ -> print_plain ppf o);
  if o.is_shadowless then Format.pp_print_string ppf " shadowless"

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
  Format.fprintf ppf "bcolor %s@\n" (color scene.background);
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
  List.iter
    (fun (o : Object.t) ->
      Format.fprintf ppf "%a%s@\n" print_object o (comment o.origin))
    scene.objects

let print = print_with (fun _ -> "")

let expand ppf scene =
  let comment origin =
    match Scene.provenance scene origin with
    | None -> ""
    | Some place -> "  # " ^ Printable.text (Provenance.to_string place)
  in
  print_with comment ppf scene
