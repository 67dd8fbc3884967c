open Raylab_source

let failed error =
  Access.refuse (String.uncapitalize_ascii (Unix.error_message error))

let real path =
  match Unix.realpath path with
  | real -> Some real
  | exception Unix.Unix_error _ -> None

let is_in file folder = file = folder || Access.below folder file <> None

let outside () =
  Access.refuse "it lies outside of the folder of the scene"
    ~advice:"if it may be read, say so: --allow and the folder in which it is"

(* Where it may be is decided before it is told what is there. *)
let find folders ~from name =
  let path = Access.join ~from name in
  if name = "" then Access.refuse "the name of the file is empty"
  else
    match Unix.realpath path with
    | identity when List.exists (is_in identity) folders ->
        Ok { Access.path; identity }
    | _ -> outside ()
    | exception Unix.Unix_error (error, _, _) -> (
        match real (Filename.dirname path) with
        | Some folder when not (List.exists (is_in folder) folders) ->
            outside ()
        | _ -> failed error)

let kind : Unix.file_kind -> string option = function
  | S_REG -> None
  | S_DIR -> Some "it is a folder"
  | S_CHR | S_BLK -> Some "it is a device"
  | S_FIFO -> Some "it is a pipe"
  | S_SOCK -> Some "it is a socket"
  | S_LNK -> Some "it is a link"

let too_large limit =
  Access.refuse
    (Printf.sprintf "it has more than the %d bytes that are left for it" limit)

let rec read_all descriptor ~limit text chunk =
  match Unix.read descriptor chunk 0 (Bytes.length chunk) with
  | 0 -> Ok (Buffer.contents text)
  | count when Buffer.length text + count > limit -> too_large limit
  | count ->
      Buffer.add_subbytes text chunk 0 count;
      read_all descriptor ~limit text chunk

(* Opening a pipe must not wait, nor a device do anything. *)
let read ~limit { Access.identity; _ } =
  match
    let flags = [ Unix.O_RDONLY; O_NONBLOCK; O_CLOEXEC; O_NOCTTY ] in
    match kind (Unix.LargeFile.stat identity).st_kind with
    | Some kind -> Access.refuse (kind ^ ", not a file")
    | None ->
        let descriptor = Unix.openfile identity flags 0 in
        Fun.protect
          ~finally:(fun () -> Unix.close descriptor)
          (fun () ->
            let { Unix.LargeFile.st_size; _ } =
              Unix.LargeFile.fstat descriptor
            in
            if st_size > Int64.of_int limit then too_large limit
            else
              let text = Buffer.create (Int64.to_int st_size + 1) in
              read_all descriptor ~limit text (Bytes.create 65536))
  with
  | text -> text
  | exception Unix.Unix_error (error, _, _) -> failed error

let access ?(allow = []) main =
  let is_stream = not (Raylab_picture.Target.has_name main) in
  (* what has no folder is as if it were in the current one *)
  let named path = if is_stream && path = main then "-" else path in
  let folder =
    if is_stream then Filename.current_dir_name else Filename.dirname main
  in
  let folders = List.filter_map real (folder :: allow) in
  {
    Access.main = (if is_stream then None else real main);
    find = (fun ~from name -> find folders ~from:(named from) name);
    read;
  }
