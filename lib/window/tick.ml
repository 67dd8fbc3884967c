exception Tick

let not_here () = ignore (Unix.sigprocmask SIG_BLOCK [ Sys.sigalrm ])

let set_timer seconds =
  ignore
    (Unix.setitimer ITIMER_REAL { it_value = seconds; it_interval = seconds })

let quiet () =
  set_timer 0.;
  (* not the default, with which a late tick would end the program *)
  Sys.set_signal Sys.sigalrm (Signal_handle ignore)

let within ~seconds wait =
  let waiting = ref true in
  let on_tick _ =
    (* another domain may have got it *)
    if !waiting && Domain.is_main_domain () then raise_notrace Tick
  in
  Sys.set_signal Sys.sigalrm (Signal_handle on_tick);
  let stop () =
    waiting := false;
    quiet ()
  in
  match
    (* it goes on ticking: a tick just before the call blocks is not the last *)
    set_timer seconds;
    let result = wait () in
    waiting := false;
    result
  with
  | result ->
      stop ();
      Some result
  | exception Tick ->
      stop ();
      None
  | exception failure ->
      stop ();
      raise failure
