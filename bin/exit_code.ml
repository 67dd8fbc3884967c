let ok = 0
let scene_error = 1
let refused = 1
let not_written = 2
let usage = Cmdliner.Cmd.Exit.cli_error
let failed = Cmdliner.Cmd.Exit.internal_error
let interrupted = 130
let hung_up = 129
let terminated = 143
let quit = 131
let out_of_time = 152
let unread = 141

let infos =
  let info code doc = Cmdliner.Cmd.Exit.info code ~doc in
  [
    info ok "on success.";
    info scene_error
      "if the scene is in error or cannot be read, or if bands do not make a \
       picture.";
    info not_written
      "if a picture or other output could not be written, not shown for want \
       of a display, or a job not submitted.";
    info usage "if the command line is wrong.";
    info interrupted
      "if interrupted by Ctrl-C; a picture that is not whole is not written.";
    info hung_up
      "if the terminal went away; a picture that is not whole is not written.";
    info terminated
      "if ended by a signal; a picture that is not whole is not written.";
    info unread
      "if the reader of its output went away: it dies of SIGPIPE, without a \
       word, as other programs do.";
    info failed "if memory runs out, or on an error of raylab itself.";
  ]
