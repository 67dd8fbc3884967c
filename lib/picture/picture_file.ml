open Raylab_tracer

type format = Bmp | Png | Ppm

let formats = [ (".bmp", Bmp); (".png", Png); (".ppm", Ppm) ]

let format_of_path path =
  match String.lowercase_ascii (Filename.extension path) with
  | "" -> Ok Bmp
  | extension -> (
      match List.assoc_opt extension formats with
      | Some format -> Ok format
      | None ->
          Error
            (Printf.sprintf
               "%s: there is no picture format '%s'; use .bmp, .png or .ppm"
               path extension))

let most_bytes = 1 lsl 32

(* The library that writes PNG crashes from about 26,000 pixels a side on. *)
let longest_png_side = 25_000

let check_size format ~width ~height =
  let bytes = 3. *. float_of_int width *. float_of_int height in
  if bytes > float_of_int most_bytes then
    Error
      (Printf.sprintf
         "a picture of %d x %d pixels would take %.1f GiB of memory; the limit \
          is %d GiB"
         width height (bytes /. 0x1p30) (most_bytes lsr 30))
  else if format = Png && Int.max width height > longest_png_side then
    Error
      (Printf.sprintf
         "a PNG of %d x %d pixels is too large; the limit is %d a side. Use \
          .bmp or .ppm"
         width height longest_png_side)
  else Ok ()

(* {1 Writing} *)

let write_file format path picture =
  let image =
    Images.Rgb24
      (Rgb24.create_with (Picture.width picture) (Picture.height picture) []
         (Picture.to_rgb picture))
  in
  match format with
  | Bmp -> Bmp.save path [] image
  | Png -> Png.save path [] image
  | Ppm -> Ppm.save path [] image

(* The last chunk of every PNG file. *)
let png_end = "\x00\x00\x00\x00IEND\xae\x42\x60\x82"

(* libpng's caller does not look whether its last write succeeded. *)
let check_whole format path =
  let is_whole () =
    In_channel.with_open_bin path (fun channel ->
        let length = In_channel.length channel in
        let tail = Int64.of_int (String.length png_end) in
        length > tail
        &&
        (In_channel.seek channel (Int64.sub length tail);
         In_channel.input_all channel = png_end))
  in
  if format = Png && not (is_whole ()) then
    raise (Sys_error "no space left on the device?")

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

let write_whole format path picture =
  write_file format path picture;
  check_whole format path;
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
  | exception (Sys_error reason | Failure reason) -> error (without_path reason)

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

let output_exn format channel picture =
  let dir = Filename.get_temp_dir_name () in
  if not (Sys.file_exists dir) then
    raise (Sys_error ("there is no folder " ^ dir ^ " for temporary files"));
  Out_channel.set_binary_mode channel true;
  with_temporary dir (fun part ->
      write_whole format part picture;
      copy_to channel part)

let output format channel picture =
  reporting "standard output" (fun () ->
      try output_exn format channel picture
      with failure ->
        (* what is still in its buffer must not fail again at the exit *)
        close_out_noerr channel;
        raise failure)

let save_beside format path ~permissions picture =
  with_temporary (Filename.dirname path) (fun part ->
      write_whole format part picture;
      Unix.chmod part permissions;
      Unix.rename part path)

let umask () =
  let mask = Unix.umask 0 in
  ignore (Unix.umask mask);
  mask

let save_new format path picture =
  save_beside format path ~permissions:(0o666 land lnot (umask ())) picture

let rec save_exn format path picture =
  match Unix.stat path with
  | { st_kind = S_REG; st_perm; _ } ->
      Unix.access path [ W_OK ];
      save_beside format (Unix.realpath path) ~permissions:st_perm picture
  | { st_kind = S_DIR; _ } -> raise (Sys_error "is a directory")
  | _ ->
      Out_channel.with_open_bin path (fun channel ->
          output_exn format channel picture)
  | exception Unix.Unix_error (ENOENT, _, _) -> (
      match Unix.readlink path with
      | target when Filename.is_relative target ->
          let beside = Filename.concat (Filename.dirname path) target in
          save_exn format beside picture
      | target -> save_exn format target picture
      | exception Unix.Unix_error _ -> save_new format path picture)

let save format ~path picture =
  reporting path (fun () -> save_exn format path picture)
