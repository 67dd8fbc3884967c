open Cmdliner
open Raylab_source
open Raylab_language

exception Ended of int

(* Standard error may be closed or full. There is nobody to tell then, and the
   work itself goes on. *)
let print_line line =
  try
    prerr_string (line ^ "\n");
    flush stderr
  with Sys_error _ -> close_out_noerr stderr

(* File names and the like come from outside, and a terminal obeys what it is
   sent. *)
let line format =
  Printf.ksprintf (fun text -> print_line (Printable.text text)) format

let say format = line ("raylab: " ^^ format)

let usage_errors =
  let out = Format.pp_get_formatter_out_functions Format.err_formatter () in
  let out_string text first length =
    let text = Printable.text (String.sub text first length) in
    out.out_string text 0 (String.length text)
  in
  Format.formatter_of_out_functions { out with out_string }

let end_with code format =
  Printf.ksprintf
    (fun message ->
      say "%s" message;
      raise (Ended code))
    format

let usage_error format = end_with Exit_code.usage format

let refuse messages =
  List.iter (say "%s") messages;
  raise (Ended Exit_code.refused)

let write_error message = end_with Exit_code.not_written "%s" message

let scene_arg =
  let doc = "The scene file, or $(b,-) for standard input." in
  Arg.(required & pos 0 (some string) None & info [] ~docv:"SCENE" ~doc)

let print_error error = print_line (Format.asprintf "%a" Scene_error.pp error)

let scene_or_errors = function
  | Ok scene -> scene
  | Error errors ->
      List.iter print_error errors;
      raise (Ended Exit_code.scene_error)

let read_scene ~allow path =
  let access = Raylab_disk.Disk.access ~allow in
  let reading = Scene_file.read ~access path in
  (reading, scene_or_errors reading.scene)

let handed_over path =
  match In_channel.with_open_bin path Raylab_toplevel.Handover.read with
  | Ok scene -> scene
  | Error message | (exception Sys_error message) ->
      end_with Exit_code.failed "%s" message

let is_same_file a b =
  match (Unix.stat a, Unix.stat b) with
  | a, b -> a.st_dev = b.st_dev && a.st_ino = b.st_ino
  | exception Unix.Unix_error _ -> false

let failed reason =
  say "%s" reason;
  Exit_code.failed

let run action =
  let run action =
    (* nobody needs to read its messages *)
    match Signals.despite_readers action with
    | () -> Exit_code.ok
    | exception Ended code -> code
    | exception Out_of_memory -> failed "out of memory"
    | exception Raylab_tracer.Chain.Too_long { ray_depth } ->
        failed (Raylab_tracer.Chain.too_long ~ray_depth)
    | exception Raylab_tracer.Unpainted.Found lines ->
        List.iter (say "%s") lines;
        Exit_code.scene_error
    | exception Stack_overflow -> failed "out of memory for the stack"
    | exception failure ->
        failed ("an error of raylab itself: " ^ Printexc.to_string failure)
  in
  Term.(const run $ action)

let is_description : Manpage.block -> bool = function
  | `S section -> section = Manpage.s_description
  | `P _ -> true
  | _ -> false

(* Cmdliner keeps sections in the order in which it gets them. *)
let rec with_common_options = function
  | block :: rest when is_description block ->
      block :: with_common_options rest
  | rest ->
      `S Manpage.s_common_options
      :: `I ("$(b,-h)", "Show this help, as $(b,--help) does.")
      :: rest

let info ?version ?(exits = Exit_code.infos) name ~doc man =
  let man_xrefs = [ `Main; `Page Guide.manual ] in
  Cmd.info name ?version ~doc ~man:(with_common_options man) ~man_xrefs ~exits
