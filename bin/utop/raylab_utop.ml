open Raylab_toplevel

let argument k =
  if k < Array.length Sys.argv && Sys.argv.(k) <> "" then Some Sys.argv.(k)
  else None

(* [load path] tells what is wrong with the scene, and is whether it is
   right. *)
let load path =
  let reading = Session.load path in
  let scene = reading.Raylab_language.Scene_file.scene in
  Result.iter_error Console.errors scene;
  Console.warnings ~path (Raylab_language.Scene_file.warnings reading);
  Result.is_ok scene

let run_script scene path =
  (* what a script says of another scene than its own is of no use *)
  if Option.fold ~none:true ~some:load scene then Prompt.script path else 1

let greeting scene () =
  let tell path = if load path then Console.contents path (Session.scene ()) in
  Option.iter tell scene;
  Format.printf "help () lists what raylab knows; Ctrl-D leaves.@."

(* Before OCaml's own flushing at the end, which takes a failure for a bug. *)
let flush_or_tell () =
  try
    Format.print_flush ();
    flush stdout
  with Sys_error reason ->
    prerr_endline ("raylab: standard output: " ^ reason);
    Unix._exit 2

let prompt scene =
  let is_terminal = Unix.isatty Unix.stdin && Unix.isatty Unix.stdout
  and greeting = greeting scene in
  match Sys.getenv_opt "TERM" with
  | _ when not is_terminal ->
      Option.iter (fun path -> ignore (load path : bool)) scene;
      Prompt.standard_input ()
  | None | Some ("" | "dumb") -> Prompt.plain_terminal ~greeting
  | Some _ -> Prompt.terminal ~greeting

let () =
  at_exit flush_or_tell;
  (* raylab ignores it, and that is inherited *)
  Sys.set_signal Sys.sigpipe Signal_default;
  (* a file that may not grow is an error of writing *)
  Sys.set_signal Sys.sigxfsz Signal_ignore;
  let scene = argument 1 in
  let script = argument 2 in
  let given = Array.to_list Sys.argv in
  Session.allow (List.filteri (fun k _ -> k > 2) given);
  Loader.install ();
  Prompt.prepare ();
  match script with
  | Some path -> exit (run_script scene path)
  | None -> prompt scene
