type t = { path : string; channel : out_channel }

let file part = Unix.descr_of_out_channel part.channel
let paths = Atomic.make []
let in_use () = Atomic.get paths

let rec change f =
  let old = Atomic.get paths in
  if not (Atomic.compare_and_set paths old (f old)) then change f

let note path = change (List.cons path)
let forget path = change (List.filter (fun other -> other <> path))

(* No other process, here or on another machine, makes the same. *)
let name kind =
  let now = Int64.bits_of_float (Unix.gettimeofday ()) in
  Printf.sprintf ".raylab-%d-%Lx.%s" (Unix.getpid ()) now kind

(* It is noted before it is there: a signal may come as soon as it is. *)
let rec make folder kind =
  let path = Filename.concat folder (name kind) in
  note path;
  match Unix.openfile path [ O_RDWR; O_CREAT; O_EXCL; O_CLOEXEC ] 0o600 with
  | file -> { path; channel = Unix.out_channel_of_descr file }
  | exception failure -> (
      forget path;
      match failure with
      | Unix.Unix_error (EEXIST, _, _) -> make folder kind
      | _ -> raise failure)

let use part f =
  Fun.protect
    ~finally:(fun () ->
      close_out_noerr part.channel;
      (try Sys.remove part.path with Sys_error _ -> ());
      forget part.path)
    (fun () -> f part)
