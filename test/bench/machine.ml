let cores = Domain.recommended_domain_count

let first_line path =
  try In_channel.with_open_text path In_channel.input_line
  with Sys_error _ -> None

let processor () =
  let model line =
    match String.split_on_char ':' line with
    | [ name; value ] when String.trim name = "model name" ->
        Some (String.trim value)
    | _ -> None
  in
  try
    In_channel.with_open_text "/proc/cpuinfo" In_channel.input_all
    |> String.split_on_char '\n' |> List.find_map model
    |> Option.value ~default:"unknown"
  with Sys_error _ -> "unknown"

(* What the programs running when the benchmark starts take away from it. *)
let load () =
  match Option.map (String.split_on_char ' ') (first_line "/proc/loadavg") with
  | Some (minute :: _) -> minute
  | _ -> "unknown"

let commit () =
  let git arguments = Child.run "git" arguments in
  match git [ "rev-parse"; "--short"; "HEAD" ] with
  | Error _ -> "unknown"
  | Ok { output; _ } -> (
      let commit = String.trim output in
      match git [ "status"; "--porcelain"; "lib" ] with
      | Ok { output = ""; _ } -> commit
      | _ -> commit ^ ", with changes")

let date () =
  let { Unix.tm_year; tm_mon; tm_mday; _ } = Unix.gmtime (Unix.time ()) in
  Printf.sprintf "%d-%02d-%02d" (tm_year + 1900) (tm_mon + 1) tm_mday

let describe () =
  [
    ("date", date ());
    ("processor", Printf.sprintf "%s, %d cores" (processor ()) (cores ()));
    ("load before the start", load ());
    ("OCaml", Sys.ocaml_version ^ ", dune profile " ^ Profile.name);
    ("raylab", "commit " ^ commit ());
    ("POV-Ray", Option.value (Povray.version ()) ~default:"not installed");
  ]
