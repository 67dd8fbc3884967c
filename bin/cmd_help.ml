open Cmdliner

let help commands command =
  match command with
  | Some command when not (List.mem command commands) ->
      `Error
        ( false,
          Printf.sprintf "there is no command '%s'; raylab help lists them"
            command )
  | _ -> `Help (`Auto, command)

let command =
  let doc = "The command. Without it the manual is that of raylab itself." in
  Arg.(value & pos 0 (some string) None & info [] ~docv:"COMMAND" ~doc)

let cmd =
  let man =
    [
      `S Manpage.s_description;
      `P "Shows the manual of $(i,COMMAND), as $(b,--help) after it does.";
    ]
  in
  Cmd.v
    (Command.info "help" ~doc:"show the manual of a command" man)
    Term.(ret (const help $ choice_names $ command))

(* Without its value, --help would take the next argument for it. *)
let rec with_long_options = function
  | "--" :: _ as rest -> rest
  | "-h" :: rest -> "--help=auto" :: with_long_options rest
  | argument :: rest -> argument :: with_long_options rest
  | [] -> []
