open Raylab_scene
open Raylab_language
open Raylab_tracer
open Raylab_picture
open Raylab_window

let variable = "RAYLAB_PROGRAM"

let program () =
  match Sys.getenv_opt variable with
  | Some path when Sys.file_exists path -> Some path
  | _ -> None

(* {1 Reading the program's picture}

   It is the BMP of Picture_file. *)

let read_header channel =
  let start = really_input_string channel 14 in
  let offset = Int32.to_int (String.get_int32_le start 10) in
  let header = really_input_string channel (offset - 14) in
  let field at = Int32.to_int (String.get_int32_le header at) in
  (field 4, field 8)

let read_picture channel =
  let width, height = read_header channel in
  let picture = Picture.create ~width ~height in
  let rgb = Picture.to_rgb picture in
  let row = Bytes.create (Uncompressed.stride Bmp ~width) in
  for y = height - 1 downto 0 do
    really_input channel row 0 (Bytes.length row);
    let decoded = Uncompressed.decode Bmp ~width row in
    Bytes.blit decoded 0 rgb (3 * width * y) (3 * width)
  done;
  picture

(* {1 Running the program} *)

let remove_quietly remove path = try remove path with Sys_error _ -> ()

let with_scene_file ?(name = "scene") scene f =
  let directory = Filename.temp_dir "raylab" "" in
  let path = Filename.concat directory name in
  let write channel = Handover.write channel scene in
  Fun.protect
    ~finally:(fun () ->
      remove_quietly Sys.remove path;
      remove_quietly Sys.rmdir directory)
    (fun () ->
      (try Out_channel.with_open_bin path write
       with Sys_error reason -> raise (Sys_error (path ^ ": " ^ reason)));
      f path)

(* Ctrl-C goes to the program as well, which then ends by itself: so it must
   have started, and be waited for, whenever Ctrl-C comes. *)
let start program arguments ~output =
  let interrupted = ref false in
  let note = Sys.Signal_handle (fun _ -> interrupted := true) in
  let before = Sys.signal Sys.sigint note in
  Fun.protect
    ~finally:(fun () -> Sys.set_signal Sys.sigint before)
    (fun () ->
      let pid =
        Unix.create_process program
          (Array.of_list (program :: arguments))
          Unix.stdin output Unix.stderr
      in
      if !interrupted then Unix.kill pid Sys.sigint;
      pid)

let end_of pid =
  let rec wait () =
    match Unix.waitpid [] pid with
    | _, status -> status
    | exception Unix.Unix_error (EINTR, _, _) -> wait ()
  in
  wait ()

let failed program : Unix.process_status -> _ = function
  | WSIGNALED signal when signal = Sys.sigint -> raise Sys.Break
  | WSIGNALED _ -> failwith (program ^ " was ended by a signal")
  | WEXITED code | WSTOPPED code ->
      failwith (Printf.sprintf "%s ended with status %d" program code)

let render_with program path =
  let output, input = Unix.pipe ~cloexec:true () in
  let channel = Unix.in_channel_of_descr output in
  set_binary_mode_in channel true;
  let pid =
    start program [ "render"; "--from-prompt"; path; "-o"; "-" ] ~output:input
  in
  let picture =
    try
      Unix.close input;
      Ok (read_picture channel)
    with
    | End_of_file -> Error None
    | exn -> Error (Some exn)
  in
  close_in channel;
  match (picture, end_of pid) with
  | Ok picture, WEXITED 0 -> picture
  | Error (Some exn), _ -> raise exn
  | _, status -> failed program status

let check_size (scene : Scene.t) =
  let { Camera.width; height; _ } = scene.camera in
  Result.iter_error
    (fun message -> raise (Sys_error message))
    (Picture_file.check_size Bmp ~width ~height)

let picture scene =
  check_size scene;
  match program () with
  | Some program -> with_scene_file scene (render_with program)
  | None -> fst (Render.picture (Prepared.make scene))

(* {1 The window} *)

let no_display = 2

let show_with program options path =
  let arguments = ("view" :: options) @ [ "--"; path ] in
  match end_of (start program arguments ~output:Unix.stdout) with
  | WEXITED 0 -> ()
  | WEXITED code when code = no_display -> () (* it has said so *)
  | status -> failed program status

(* Then the program says the lines that the prompt says. *)
let still_has scene file =
  match (Session.read file).scene with
  | Ok found -> Scene.equal found scene
  | Error _ -> false

let show_here ~name ~out scene =
  let save picture =
    match Picture_file.save Bmp ~path:out picture with
    | Ok outcome -> Atomic_file.wrote ~path:out outcome
    | Error message -> message
  in
  let load () = Ok scene
  and can_save () = Atomic_file.check ~path:out ~bytes:1 in
  let source = { View.name; load; can_save; save } in
  let terminal = Terminal.make stdout ~tell:prerr_endline in
  Result.iter_error prerr_endline (View.run ~terminal source (Scene scene))

let show ?file ?(time = 0.) scene =
  check_size scene;
  Format.print_flush ();
  let path = Option.value file ~default:"scene" in
  let name = Filename.basename path
  and out = Scene_file.without_extension path ^ ".bmp" in
  match (program (), file) with
  | None, _ -> show_here ~name ~out scene
  | Some program, Some file when time = 0. && still_has scene file ->
      let allow folder = "--allow=" ^ folder in
      show_with program (List.map allow (Session.allowed ())) file
  | Some program, _ ->
      with_scene_file ~name scene
        (show_with program [ "--from-prompt"; "--output=" ^ out ])
