let flush_to_disk path =
  let file = Unix.openfile path [ O_RDWR ] 0 in
  Fun.protect ~finally:(fun () -> Unix.close file) (fun () -> Unix.fsync file)

let in_use = Atomic.make []
let temporary () = Atomic.get in_use

let rec change_in_use f =
  let old = Atomic.get in_use in
  if not (Atomic.compare_and_set in_use old (f old)) then change_in_use f

(* [with_temporary dir use] is [use path] for the path of a new, empty file in
   [dir], which is removed if it is still there afterwards. *)
let with_temporary dir use =
  let path = Filename.temp_file ~temp_dir:dir ".raylab-" ".part" in
  change_in_use (List.cons path);
  Fun.protect
    ~finally:(fun () ->
      if Sys.file_exists path then Sys.remove path;
      change_in_use (List.filter (fun other -> other <> path)))
    (fun () -> use path)

let write_whole write path =
  write path;
  flush_to_disk path

(* {1 Reporting failures} *)

(* The system's messages start with the path, which here is a temporary one. *)
let without_path reason =
  match String.rindex_opt reason ':' with
  | Some i ->
      String.trim (String.sub reason (i + 1) (String.length reason - i - 1))
  | None -> reason

(* [reporting name f] turns the ways in which writing fails into a message. *)
let reporting name f =
  let error reason = Error (Printf.sprintf "%s: %s" name reason) in
  match f () with
  | () -> Ok ()
  | exception Unix.Unix_error (code, _, _) -> error (Unix.error_message code)
  | exception (Sys_error reason | Failure reason) ->
      error (without_path reason)

let copy_to channel path =
  In_channel.with_open_bin path (fun source ->
      let chunk = Bytes.create 65536 in
      let rec copy () =
        match In_channel.input source chunk 0 (Bytes.length chunk) with
        | 0 -> flush channel
        | n ->
            Out_channel.output channel chunk 0 n;
            copy ()
      in
      copy ())

let output_exn channel write =
  let dir = Filename.get_temp_dir_name () in
  if not (Sys.file_exists dir) then
    raise (Sys_error ("there is no folder " ^ dir ^ " for temporary files"));
  Out_channel.set_binary_mode channel true;
  with_temporary dir (fun part ->
      write_whole write part;
      copy_to channel part)

(* What is still in the buffer of a channel that fails must not fail again at
   the exit. *)
let closing_if_it_fails channel f =
  try f ()
  with failure ->
    close_out_noerr channel;
    raise failure

let output channel write =
  reporting "standard output" (fun () ->
      closing_if_it_fails channel (fun () -> output_exn channel write))

let print text =
  reporting "standard output" (fun () ->
      closing_if_it_fails stdout (fun () ->
          print_string text;
          flush stdout))

let save_beside path ~permissions write =
  with_temporary (Filename.dirname path) (fun part ->
      write_whole write part;
      Unix.chmod part permissions;
      Unix.rename part path)

let umask () =
  let mask = Unix.umask 0 in
  ignore (Unix.umask mask);
  mask

let save_new path write =
  save_beside path ~permissions:(0o666 land lnot (umask ())) write

let rec save_exn path write =
  match Unix.stat path with
  | { st_kind = S_REG; st_perm; _ } ->
      Unix.access path [ W_OK ];
      save_beside (Unix.realpath path) ~permissions:st_perm write
  | { st_kind = S_DIR; _ } -> raise (Sys_error "is a directory")
  | _ ->
      Out_channel.with_open_bin path (fun channel -> output_exn channel write)
  | exception Unix.Unix_error (ENOENT, _, _) -> (
      match Unix.readlink path with
      | target when Filename.is_relative target ->
          let beside = Filename.concat (Filename.dirname path) target in
          save_exn beside write
      | target -> save_exn target write
      | exception Unix.Unix_error _ -> save_new path write)

let save ~path write = reporting path (fun () -> save_exn path write)
