open Raylab_parallel
open Test_support

let each = List.iter
let domains = [ 1; 2; 4; 9 ]

(* Each domain writes to cells of its own, so plain cells would hide it if one
   were taken twice; atomic ones count. *)
let test_once () =
  each
    (fun domains ->
      each
        (fun count ->
          let taken = Array.init count (fun _ -> Atomic.make 0) in
          let workers =
            Parallel.iter ~domains ~worker:ignore ~count (fun () k ->
                Atomic.incr taken.(k))
          in
          let what = Printf.sprintf "%d by %d domains" count domains in
          Alcotest.(check bool)
            what true
            (Array.for_all (fun n -> Atomic.get n = 1) taken);
          let n = List.length workers in
          Alcotest.(check bool) "workers" true (1 <= n && n <= domains))
        [ 0; 1; 2; 3; 1000 ])
    domains

(* What the workers kept for themselves is all the work, whoever did it. *)
let test_workers () =
  each
    (fun domains ->
      let sums =
        Parallel.iter ~domains
          ~worker:(fun () -> ref 0)
          ~count:101
          (fun sum k -> sum := !sum + k)
      in
      (* 0 + 1 + ... + 100 *)
      Alcotest.(check int)
        "sum" 5050
        (List.fold_left (fun total sum -> total + !sum) 0 sums))
    domains

(* Told on the calling domain only, after each piece of its own. *)
let test_progress () =
  let told = ref [] and caller = Domain.self () in
  let on_progress n =
    Alcotest.(check bool) "the calling domain" true (Domain.self () = caller);
    told := n :: !told
  in
  ignore
    (Parallel.iter ~domains:1 ~on_progress ~worker:ignore ~count:5 (fun () _ ->
         ()));
  Alcotest.(check (list int)) "alone" [ 5; 4; 3; 2; 1 ] !told;
  told := [];
  ignore
    (Parallel.iter ~domains:3 ~on_progress ~worker:ignore ~count:100
       (fun () _ -> ()));
  Alcotest.(check bool)
    "never less than before, never more than there is" true
    (List.sort Int.compare !told = List.rev !told
    && List.for_all (fun n -> 1 <= n && n <= 100) !told)

let test_bounds () =
  each
    (fun domains ->
      Expect.invalid (string_of_int domains) (fun () ->
          Parallel.iter ~domains ~worker:ignore ~count:1 (fun () _ -> ())))
    [ 0; -1; Parallel.max_domains + 1 ];
  let n = Parallel.default_domains () in
  Alcotest.(check bool) "default" true (1 <= n && n <= Parallel.max_domains);
  (* as many domains as the runtime has *)
  ignore
    (Parallel.iter ~domains:Parallel.max_domains ~worker:ignore ~count:1000
       (fun () _ -> ()))

let suite =
  ( "Parallel.iter",
    [
      Alcotest.test_case "each once" `Quick test_once;
      Alcotest.test_case "workers" `Quick test_workers;
      Alcotest.test_case "progress" `Quick test_progress;
      Alcotest.test_case "bounds" `Quick test_bounds;
    ] )
