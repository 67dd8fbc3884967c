type outcome = Regular_file.outcome = Whole | In_place of string

let wrote ~path = function
  | Whole -> "wrote " ^ path
  | In_place reason ->
      Printf.sprintf
        "wrote %s by copying over what was there, for it cannot be replaced \
         (%s). Had that failed, neither the older nor the new one would be \
         whole"
        path reason

let temporary = Temporary.in_use

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
  | result -> Ok result
  | exception Unix.Unix_error (EISDIR, _, _) -> error "is a directory"
  | exception Unix.Unix_error (code, _, _) -> error (Unix.error_message code)
  | exception Regular_file.Failed reason -> error reason
  | exception (Sys_error reason | Failure reason) ->
      error (without_path reason)

(* {1 Streams} *)

(* What is still in the buffer of a channel that fails must not fail again at
   the exit. *)
let write_to channel write =
  try
    set_binary_mode_out channel true;
    write channel;
    flush channel
  with failure ->
    close_out_noerr channel;
    raise failure

let output channel write =
  reporting "standard output" (fun () -> write_to channel write)

let print text = output stdout (fun channel -> output_string channel text)

let write_through file write =
  let channel = Unix.out_channel_of_descr file in
  write_to channel write;
  close_out channel;
  Whole

(* What another process has open is appended to: its place there is its own. *)
let stream path =
  Unix.openfile path [ O_WRONLY; O_APPEND; O_NOCTTY; O_CLOEXEC ] 0

let check_descriptor n =
  if not (Descriptor.is_writable n) then
    raise (Unix.Unix_error (EBADF, "write", ""))

(* A pipe is not opened before there is something to write: its reader would
   wait. *)
let check_stream path =
  Unix.access path [ W_OK ];
  match (Unix.stat path).st_kind with
  | S_CHR | S_BLK -> Unix.close (stream path)
  | _ -> ()

(* {1 Any path} *)

let save ~path write =
  reporting path (fun () ->
      match Target.of_path path with
      | File (path, old) -> Regular_file.write path (Some old) write
      | Nothing path -> Regular_file.write path None write
      | Descriptor n -> write_through (Descriptor.duplicate n) write
      | Stream path -> write_through (stream path) write)

let check ~path ~bytes =
  reporting path (fun () ->
      match Target.of_path path with
      | File (path, old) -> Regular_file.check path (Some old) ~bytes
      | Nothing path -> Regular_file.check path None ~bytes
      | Descriptor n -> check_descriptor n
      | Stream path -> check_stream path)

let check_output () =
  reporting "standard output" (fun () -> check_descriptor 1)
