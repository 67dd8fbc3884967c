type clock = { wall : float; cpu : float }

let timed work =
  let wall = Unix.gettimeofday () and cpu = Sys.time () in
  let result = work () in
  (result, { wall = Unix.gettimeofday () -. wall; cpu = Sys.time () -. cpu })

(* A forked process leaves without at_exit: what is buffered is the parent's. *)
let fork work =
  flush_all ();
  match Unix.fork () with 0 -> Unix._exit (work ()) | pid -> pid

(* Whatever ends [work], an interrupt for instance, leaves no child behind. *)
let with_child pid work =
  try work pid
  with failure ->
    let backtrace = Printexc.get_raw_backtrace () in
    (try
       Unix.kill pid Sys.sigkill;
       ignore (Unix.waitpid [] pid)
     with Unix.Unix_error _ -> ());
    Printexc.raise_with_backtrace failure backtrace

let wait pid =
  match snd (Unix.waitpid [] pid) with
  | Unix.WEXITED 0 -> Ok ()
  | WEXITED code -> Error (Printf.sprintf "exit code %d" code)
  | WSIGNALED _ | WSTOPPED _ -> Error "killed by a signal"

let compute work =
  let read_end, write_end = Unix.pipe ~cloexec:true () in
  let answer () =
    let result = try Ok (work ()) with e -> Error (Printexc.to_string e) in
    let channel = Unix.out_channel_of_descr write_end in
    Marshal.to_channel channel result [];
    close_out channel;
    0
  in
  with_child (fork answer) (fun pid ->
      Unix.close write_end;
      let channel = Unix.in_channel_of_descr read_end in
      let result =
        try Marshal.from_channel channel
        with End_of_file | Failure _ -> Error "no result"
      in
      close_in channel;
      Result.bind (wait pid) (fun () -> result))

(* {1 Programs} *)

type outcome = { output : string; clock : clock }

(* The system adds up the processor time of children that were waited for. *)
let children_cpu () =
  let { Unix.tms_cutime; tms_cstime; _ } = Unix.times () in
  tms_cutime +. tms_cstime

let exec ?dir program arguments ~output () =
  try
    Option.iter Unix.chdir dir;
    let nothing = Unix.openfile "/dev/null" [ O_RDONLY ] 0 in
    Unix.dup2 nothing Unix.stdin;
    Unix.dup2 output Unix.stdout;
    Unix.dup2 output Unix.stderr;
    Unix.execvp program (Array.of_list (program :: arguments))
  with Unix.Unix_error _ -> 127

let run ?dir program arguments =
  let file = Filename.temp_file "raylab-bench" ".out" in
  Fun.protect
    ~finally:(fun () -> Sys.remove file)
    (fun () ->
      let output = Unix.openfile file [ O_WRONLY; O_CLOEXEC ] 0 in
      let cpu = children_cpu () and wall = Unix.gettimeofday () in
      let ended =
        with_child (fork (exec ?dir program arguments ~output)) wait
      in
      let clock =
        { wall = Unix.gettimeofday () -. wall; cpu = children_cpu () -. cpu }
      in
      Unix.close output;
      let output = In_channel.with_open_bin file In_channel.input_all in
      match ended with
      | Ok () -> Ok { output; clock }
      | Error reason ->
          Error (Printf.sprintf "%s: %s\n%s" program reason output))
