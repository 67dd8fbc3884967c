(* An exception anywhere ends the work and comes out, and nothing hangs. *)

open Raylab_parallel

exception Broken of string

let all_domains = [ 1; 2; 4 ]

let check what f =
  List.iter
    (fun domains ->
      match f domains with
      | _ -> Alcotest.failf "%s, %d domains: nothing raised" what domains
      | exception Broken name -> Alcotest.(check string) what what name)
    all_domains

let test_work () =
  check "work" (fun domains ->
      Parallel.iter ~domains ~worker:ignore ~count:1000 (fun () k ->
          if k = 500 then raise (Broken "work")));
  check "first" (fun domains ->
      Parallel.iter ~domains ~worker:ignore ~count:1000 (fun () k ->
          if k = 0 then raise (Broken "first")));
  check "last" (fun domains ->
      Parallel.iter ~domains ~worker:ignore ~count:1000 (fun () k ->
          if k = 999 then raise (Broken "last")));
  check "every" (fun domains ->
      Parallel.iter ~domains ~worker:ignore ~count:1000 (fun () _ ->
          raise (Broken "every")))

let test_worker () =
  check "worker" (fun domains ->
      Parallel.iter ~domains
        ~worker:(fun () -> raise (Broken "worker"))
        ~count:1000
        (fun () _ -> ()))

(* Only in a domain that is not the calling one. The caller waits with its
   piece until the other has begun one. *)
let test_helper () =
  let caller = Domain.self () and begun = Atomic.make false in
  match
    Parallel.iter ~domains:2 ~worker:ignore ~count:10 (fun () _ ->
        if Domain.self () = caller then
          while not (Atomic.get begun) do
            Domain.cpu_relax ()
          done
        else (
          Atomic.set begun true;
          raise (Broken "helper")))
  with
  | _ -> Alcotest.fail "nothing raised"
  | exception Broken name -> Alcotest.(check string) "helper" "helper" name

(* The others wait for the caller's piece, so that it has one. *)
let test_progress () =
  List.iter
    (fun domains ->
      let caller = Domain.self () and told = Atomic.make false in
      match
        Parallel.iter ~domains ~worker:ignore ~count:1000
          ~on_progress:(fun _ ->
            Atomic.set told true;
            raise (Broken "progress"))
          (fun () _ ->
            if Domain.self () <> caller then
              while not (Atomic.get told) do
                Domain.cpu_relax ()
              done)
      with
      | _ -> Alcotest.fail "nothing raised"
      | exception Broken name ->
          Alcotest.(check string) "progress" "progress" name)
    all_domains

(* What is not begun when something breaks is left undone. *)
let test_stops () =
  let done_ = Atomic.make 0 in
  (match
     Parallel.iter ~domains:1 ~worker:ignore ~count:1000 (fun () k ->
         Atomic.incr done_;
         if k = 9 then raise (Broken "tenth"))
   with
  | _ -> Alcotest.fail "nothing raised"
  | exception Broken _ -> ());
  Alcotest.(check int) "pieces" 10 (Atomic.get done_);
  (* and the next work is not disturbed *)
  Alcotest.(check int)
    "afterwards" 2
    (List.length
       (Parallel.iter ~domains:2 ~worker:ignore ~count:10 (fun () _ -> ())))

(* Nor is it by the others. Each of their pieces takes so long that they cannot
   have done all. *)
let test_others_stop () =
  let caller = Domain.self () and others = Atomic.make 0 in
  (match
     Parallel.iter ~domains:2 ~worker:ignore ~count:1000 (fun () _ ->
         if Domain.self () = caller then (
           while Atomic.get others = 0 do
             Domain.cpu_relax ()
           done;
           raise (Broken "caller"))
         else (
           Atomic.incr others;
           Unix.sleepf 0.002))
   with
  | _ -> Alcotest.fail "nothing raised"
  | exception Broken _ -> ());
  Alcotest.(check bool) "not all" true (Atomic.get others < 900)

let suite =
  ( "Parallel.iter, failures",
    [
      Alcotest.test_case "in work" `Quick test_work;
      Alcotest.test_case "in worker" `Quick test_worker;
      Alcotest.test_case "in another domain" `Quick test_helper;
      Alcotest.test_case "in on_progress" `Quick test_progress;
      Alcotest.test_case "stops" `Quick test_stops;
      Alcotest.test_case "the others stop" `Quick test_others_stop;
    ] )
