let ending =
  [
    (Sys.sigint, Exit_code.interrupted);
    (Sys.sighup, Exit_code.hung_up);
    (Sys.sigterm, Exit_code.terminated);
    (Sys.sigquit, Exit_code.quit);
    (Sys.sigxcpu, Exit_code.out_of_time);
  ]

let die (signal, code) =
  Sys.set_signal signal Signal_default;
  (* the runtime blocks it while its handler runs *)
  ignore (Unix.sigprocmask SIG_UNBLOCK [ signal ] : int list);
  Unix.kill (Unix.getpid ()) signal;
  (* its default is nothing to the first process of a container *)
  Unix._exit code

(* [change signal behaviour] is what [signal] did before. *)
let change signal behaviour =
  match Sys.signal signal behaviour with
  | Signal_ignore ->
      Sys.set_signal signal Signal_ignore;
      Sys.Signal_ignore
  | before -> before

let during f change =
  let before =
    List.map (fun ((signal, _) as ending) -> (signal, change ending)) ending
  in
  let restore () =
    List.iter (fun (signal, before) -> Sys.set_signal signal before) before
  in
  Fun.protect ~finally:restore f

let cleaning clean f =
  during f (fun ((signal, _) as ending) ->
      let otherwise = ref Sys.Signal_default in
      let handle _ =
        clean ();
        match !otherwise with
        | Signal_handle handle -> handle signal
        | Signal_default | Signal_ignore -> die ending
      in
      otherwise := change signal (Signal_handle handle);
      !otherwise)

let at_once f =
  let is_first_process = Unix.getpid () = 1 in
  if is_first_process then f ()
  else during f (fun (signal, _) -> change signal Signal_default)

let with_closed_pipes behaviour f =
  let before = Sys.signal Sys.sigpipe behaviour in
  Fun.protect ~finally:(fun () -> Sys.set_signal Sys.sigpipe before) f

let despite_readers f = with_closed_pipes Signal_ignore f
let for_readers f = with_closed_pipes Signal_default f
