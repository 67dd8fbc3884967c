let default_domains = Domain.recommended_domain_count
let max_domains = 128
let never () = false

let iter ~domains ?(stop = never) ?(on_progress = ignore) ~worker ~count work =
  if domains < 1 || domains > max_domains then
    invalid_arg (Printf.sprintf "%d domains" domains);
  let next = Atomic.make 0 and finished = Atomic.make 0 in
  let run after_each () =
    let w = worker () in
    let rec loop () =
      let k = Atomic.fetch_and_add next 1 in
      if k < count && not (stop ()) then (
        work w k;
        Atomic.incr finished;
        after_each ();
        loop ())
    in
    try
      loop ();
      w
    with failure ->
      let backtrace = Printexc.get_raw_backtrace () in
      (* leaves nothing for the others to take *)
      Atomic.set next count;
      Printexc.raise_with_backtrace failure backtrace
  in
  (* where the system gives no more domains, those that there are do the work *)
  let rec spawn n =
    if n <= 0 then []
    else
      match Domain.spawn (run ignore) with
      | helper -> helper :: spawn (n - 1)
      | exception Failure _ -> []
  in
  let helpers = spawn (Int.min domains count - 1) in
  let own =
    try Ok (run (fun () -> on_progress (Atomic.get finished)) ())
    with failure -> Error (failure, Printexc.get_raw_backtrace ())
  in
  (* every domain is waited for, also when one has failed *)
  let join helper =
    try Ok (Domain.join helper)
    with failure -> Error (failure, Printexc.get_raw_backtrace ())
  in
  let results = own :: List.map join helpers in
  List.map
    (function
      | Ok w -> w
      | Error (failure, backtrace) ->
          Printexc.raise_with_backtrace failure backtrace)
    results
