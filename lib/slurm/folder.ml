open Raylab_picture

let submit folder = Filename.concat folder Job.submit
let ( let* ) = Result.bind

let for_all f =
  List.fold_left (fun done_ x -> Result.bind done_ (fun () -> f x)) (Ok ())

(* [told path f] is [f ()], whose errors are told of [path]. *)
let told path f =
  try Ok (f ())
  with Unix.Unix_error (error, _, _) ->
    Error (path ^ ": " ^ Unix.error_message error)

let make_folder path =
  if Sys.file_exists path && Sys.is_directory path then Ok ()
  else told path (fun () -> Unix.mkdir path 0o777)

(* The folders, outermost first, in which the file of this relative name is. *)
let rec folders_of name =
  let folder = Filename.dirname name in
  if folder = name || folder = "." then [] else folders_of folder @ [ folder ]

let has_text path text =
  try
    In_channel.with_open_bin path (fun channel ->
        In_channel.length channel = Int64.of_int (String.length text)
        && In_channel.input_all channel = text)
  with Sys_error _ -> false

(* Bands of another picture must not get among those of this one. *)
let check_file folder (path, text) =
  if Sys.file_exists path && not (has_text path text) then
    Error
      (Printf.sprintf
         "%s is of another job, or was edited. Run %s to go on with that job, \
          or remove %s to start anew"
         path (submit folder) folder)
  else Ok ()

let write_file (path, text) =
  if Sys.file_exists path then Ok ()
  else
    let write channel = output_string channel text in
    Result.map ignore (Atomic_file.save ~path write)

let make_executable path =
  told path (fun () ->
      let permissions = (Unix.stat path).st_perm in
      Unix.chmod path (permissions lor ((permissions land 0o444) lsr 2)))

let write folder ~files job =
  let inside = Filename.concat folder in
  let folders =
    List.concat_map (fun (name, _) -> folders_of name) files @ Job.folders
  and files =
    List.map (fun (name, text) -> (inside name, text)) (files @ Job.scripts job)
  in
  let* () = for_all (check_file folder) files in
  let* () = for_all make_folder (folder :: List.map inside folders) in
  let* () = for_all write_file files in
  make_executable (submit folder)
