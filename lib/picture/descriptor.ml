type t = Own of int | Foreign

let number text =
  if text <> "" && String.for_all (fun c -> '0' <= c && c <= '9') text then
    int_of_string_opt text
  else None

let real path = try Unix.realpath path with Unix.Unix_error _ -> ""

let of_path path =
  let folder = String.split_on_char '/' (real (Filename.dirname path)) in
  Option.bind
    (number (Filename.basename path))
    (fun n ->
      match folder with
      | [ ""; "dev"; "fd" ] -> Some (Own n)
      | [ ""; "proc"; process; "fd" ]
      | [ ""; "proc"; process; "task"; _; "fd" ] ->
          Some
            (if real "/proc/self" = "/proc/" ^ process then Own n else Foreign)
      | _ -> None)

(* There a link has the permissions of what it stands for. *)
let is_writable n =
  match Unix.lstat (Printf.sprintf "/proc/self/fd/%d" n) with
  | { st_perm; _ } -> st_perm land 0o200 <> 0
  | exception Unix.Unix_error _ -> not (Sys.file_exists "/proc/self/fd")

(* Unix does not make a descriptor of its number; the standard library makes a
   channel of it so. *)
external channel : int -> out_channel = "caml_ml_open_descriptor_out"

let duplicate n =
  Unix.dup ~cloexec:true (Unix.descr_of_out_channel (channel n))
