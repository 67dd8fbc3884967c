open Raylab_scene
open Raylab_tracer
open Raylab_toplevel
open Build

let main =
  Filename.concat
    (Filename.concat Filename.parent_dir_name Filename.parent_dir_name)
    "bin/main.exe"

let with_program path = Unix.putenv Native.variable path

let scene ~width ~height =
  Scene.make
    (Camera.with_size ~width ~height camera)
    ~background:(rgb 0.1 0.2 0.7)
    ~lights:[ spherical 20. (rgb 1. 0.5 0.25) (vec 2. 3. 0.1) ]
    ~objects:
      [
        sphere (vec 0. 0. (1. /. 3.)) 1. (diffusive (rgb 0.3 0.9 0.7));
        plane (vec 0. (-1.) 0.) (vec 0. 1. 0.) reflective;
      ]

let here scene = fst (Render.picture (Prepared.make scene))

(* Each width leaves another number of bytes to fill up in a row of BMP. *)
let test_same program () =
  with_program program;
  for width = 1 to 9 do
    let scene = scene ~width ~height:(10 - width) in
    Alcotest.(check bool)
      (Printf.sprintf "width %d" width)
      true
      (Picture.equal (here scene) (Native.picture scene))
  done

let fails program =
  with_program program;
  match Native.picture (scene ~width:3 ~height:3) with
  | _ -> Alcotest.failf "%s made a picture" program
  | exception Failure message -> message

let test_no_picture () =
  Alcotest.(check string)
    "message" "/bin/false ended with status 1" (fails "/bin/false");
  Alcotest.(check string)
    "message" "/bin/true ended with status 0" (fails "/bin/true")

(* [ended_by signal use] is [use] of a program that dies of [signal]. *)
let ended_by signal use =
  let path = Filename.temp_file "raylab" ".sh" in
  Fun.protect ~finally:(fun () -> Sys.remove path) @@ fun () ->
  Out_channel.with_open_text path (fun channel ->
      Printf.fprintf channel
        "#!/bin/sh\nexec env --default-signal=INT sh -c 'kill -%s $$'\n" signal);
  Unix.chmod path 0o700;
  use path

let test_signal () =
  ended_by "TERM" (fun program ->
      Alcotest.(check string)
        "message"
        (program ^ " was ended by a signal")
        (fails program));
  (* Ctrl-C *)
  ended_by "INT" (fun program ->
      Alcotest.check_raises "interrupted" Sys.Break (fun () ->
          ignore (fails program : string)))

let test_too_large () =
  let scene = scene ~width:1_000_000 ~height:1_000_000 in
  match Native.picture scene with
  | _ -> Alcotest.fail "no error"
  | exception Sys_error _ -> ()

let suite =
  ( "Native",
    [
      Alcotest.test_case "the program" `Quick (test_same main);
      Alcotest.test_case "no program" `Quick (test_same "/missing");
      Alcotest.test_case "no picture" `Quick test_no_picture;
      Alcotest.test_case "ended by a signal" `Quick test_signal;
      Alcotest.test_case "too large" `Quick test_too_large;
    ] )
