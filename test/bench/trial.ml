open Raylab_geometry
open Raylab_language

type t = {
  scene : Scenes.t;
  file_size : int;
  one : Measure.t list;
  many : Measure.t list;
  povray_one : Povray.t list;
  povray_many : Povray.t list;
}

type plan = { runs : int; domains : int; povray : bool }

let ( let* ) = Result.bind

let write path print =
  Out_channel.with_open_bin path (fun channel ->
      print channel;
      Out_channel.flush channel)

let print_scene scene channel =
  let ppf = Format.formatter_of_out_channel channel in
  Scene_file.print ppf scene;
  Format.pp_print_flush ppf ()

(* In a child process, so that the memory of a large scene is given back. *)
let write_files ~dir ~povray (scene : Scenes.t) =
  let path = Filename.concat dir scene.name in
  let scene_path = path ^ ".scene" and povray_path = path ^ ".pov" in
  Child.compute (fun () ->
      let made = scene.scene () in
      write scene_path (print_scene made);
      List.iter
        (fun mesh ->
          write
            (Filename.concat dir (Mesh.file mesh))
            (fun channel -> Ruffle.write channel mesh))
        (Scenes.meshes made);
      if povray then write povray_path (fun c -> Povray.write c made);
      (scene_path, povray_path))

let remove path = try Sys.remove path with Sys_error _ -> ()

let rec times n work =
  if n = 0 then Ok []
  else
    let* result = work () in
    let* results = times (n - 1) work in
    Ok (result :: results)

(* One run of each kind, as lists of one or none. *)
let round plan ~say scene_path povray_path () =
  let optional condition name work =
    if condition then (
      say name;
      Result.map (fun run -> [ run ]) (work ()))
    else Ok []
  in
  let several = plan.domains > 1 in
  let ours domains () = Measure.run ~domains scene_path in
  let theirs threads () =
    Povray.render ~threads ~width:Scenes.width ~height:Scenes.height
      povray_path
  in
  let* one = optional true "raylab, 1 domain" (ours 1) in
  let* povray_one = optional plan.povray "POV-Ray, 1 thread" (theirs 1) in
  let* many =
    optional several
      (Printf.sprintf "raylab, %d domains" plan.domains)
      (ours plan.domains)
  in
  let* povray_many =
    optional (several && plan.povray)
      (Printf.sprintf "POV-Ray, %d threads" plan.domains)
      (theirs plan.domains)
  in
  Ok (one, many, povray_one, povray_many)

let same_pictures = function
  | [] -> true
  | (first : Measure.t) :: rest ->
      List.for_all
        (fun (run : Measure.t) -> Digest.equal first.picture run.picture)
        rest

let file_size path =
  In_channel.with_open_bin path (fun channel ->
      Int64.to_int (In_channel.length channel))

let size_if_any path = if Sys.file_exists path then file_size path else 0

let perform plan ~dir ~say (scene : Scenes.t) =
  let say what = say (Printf.sprintf "%s: %s" scene.title what) in
  say "writing files";
  let* scene_path, povray_path = write_files ~dir ~povray:plan.povray scene in
  let mesh_path = Filename.concat dir (Scenes.mesh_name scene.name) in
  Fun.protect
    ~finally:(fun () ->
      List.iter remove [ scene_path; povray_path; mesh_path ])
    (fun () ->
      let* rounds = times plan.runs (round plan ~say scene_path povray_path) in
      let all part = List.concat_map part rounds in
      let one = all (fun (runs, _, _, _) -> runs)
      and many = all (fun (_, runs, _, _) -> runs) in
      if not (same_pictures (one @ many)) then
        Error (scene.title ^ ": the pictures differ from run to run")
      else
        Ok
          {
            scene;
            file_size = file_size scene_path + size_if_any mesh_path;
            one;
            many;
            povray_one = all (fun (_, _, runs, _) -> runs);
            povray_many = all (fun (_, _, _, runs) -> runs);
          })
