type outcome = Whole | In_place of string

exception Failed of string

let failed format = Printf.ksprintf (fun text -> raise (Failed text)) format

(* {1 The temporary file} *)

let elsewhere kind reason =
  let folder = Filename.get_temp_dir_name () in
  match Temporary.make folder kind with
  | part -> (part, Some ("no file can be made in its folder: " ^ reason))
  | exception Unix.Unix_error (code, _, _) ->
      failed
        "no file can be made in its folder (%s), nor in %s, the folder for \
         temporary files (%s)"
        reason folder (Unix.error_message code)

(* It is beside [path] or, if there is a file to copy it over, in the folder for
   such files, and then with the reason. *)
let temporary kind path old =
  match Temporary.make (Filename.dirname path) kind with
  | part -> (part, None)
  | exception Unix.Unix_error (((EACCES | EPERM | EROFS) as code), _, _)
    when old <> None ->
      elsewhere kind (Unix.error_message code)

let with_temporary kind path old f =
  if old <> None then Unix.access path [ W_OK ];
  let part, reason = temporary kind path old in
  Temporary.use part (fun part -> f part reason)

let fill file ~bytes =
  let chunk = Bytes.make 65536 '\000' in
  let rec fill left =
    if left > 0 then
      fill (left - Unix.write file chunk 0 (Int.min left (Bytes.length chunk)))
  in
  fill bytes

let check path old ~bytes =
  with_temporary "room" path old (fun part _ ->
      fill (Temporary.file part) ~bytes)

let may f = match f () with () -> true | exception Unix.Unix_error _ -> false

let umask () =
  let mask = Unix.umask 0 in
  ignore (Unix.umask mask : int);
  mask

(* Only root gives files away, and others only to their groups. Nobody gets the
   rights of another: what runs as its owner does no longer. *)
let take_after old file =
  let mode =
    match old with
    | None -> 0o666 land lnot (umask ())
    | Some { Unix.st_uid; st_gid; st_perm; _ } ->
        let give uid = may (fun () -> Unix.fchown file uid st_gid) in
        ignore (give st_uid || give (-1) : bool);
        st_perm land 0o777
  in
  ignore (may (fun () -> Unix.fchmod file mode) : bool)

(* {1 Writing} *)

let copy source target =
  let chunk = Bytes.create 65536 in
  let rec copy size =
    match Unix.read source chunk 0 (Bytes.length chunk) with
    | 0 -> size
    | n ->
        ignore (Unix.write target chunk 0 n : int);
        copy (size + n)
  in
  ignore (Unix.lseek source 0 SEEK_SET : int);
  copy 0

(* What was there is cut off last, so that its room is had again. *)
let copy_over path file reason =
  let target = Unix.openfile path [ O_WRONLY; O_CLOEXEC ] 0 in
  Fun.protect
    ~finally:(fun () -> Unix.close target)
    (fun () ->
      try
        Unix.ftruncate target (copy file target);
        Unix.fsync target
      with Unix.Unix_error (code, _, _) ->
        failed
          "%s. It could only be copied over what was there (%s), and neither \
           the older nor the new one is whole now"
          (Unix.error_message code) reason);
  In_place reason

let write path old write =
  with_temporary "part" path old (fun part reason ->
      write part.channel;
      flush part.channel;
      let file = Temporary.file part in
      Unix.fsync file;
      match reason with
      | Some reason -> copy_over path file reason
      | None -> (
          take_after old file;
          match Unix.rename part.path path with
          | () -> Whole
          | exception Unix.Unix_error (((EBUSY | EPERM | EACCES) as code), _, _)
            when old <> None ->
              copy_over path file (Unix.error_message code)))
