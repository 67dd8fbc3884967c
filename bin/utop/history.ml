let state () =
  match (Sys.getenv_opt "XDG_STATE_HOME", Sys.getenv_opt "HOME") with
  | Some dir, _ when not (Filename.is_relative dir) -> Some dir
  | _, Some home when home <> "" ->
      Some (Filename.concat (Filename.concat home ".local") "state")
  | _ -> None

(* The state of one user is not for others to read. *)
let rec make dir =
  if not (Sys.file_exists dir) then (
    make (Filename.dirname dir);
    Sys.mkdir dir 0o700)

let file () =
  let file_in state =
    let dir = Filename.concat state "raylab" in
    match make dir with
    | () -> Some (Filename.concat dir "history")
    | exception Sys_error _ -> None
  in
  Option.bind (state ()) file_in
