(* Throws hostile scenes at raylab; see README.md. *)

open Fuzz_support
open Raylab_parallel

let cases = ref 10_000
let seed = ref 1987
let only = ref (-1)
let folder = ref "scenes"
let long = ref false

let options =
  [
    ("--cases", Arg.Set_int cases, "N  try N small texts (10000)");
    ("--seed", Arg.Set_int seed, "N  the seed of all of them (1987)");
    ("--case", Arg.Set_int only, "K  try only the K-th and print it");
    ("--scenes", Arg.Set_string folder, "DIR  the gallery to damage (scenes)");
    ( "--long",
      Arg.Set long,
      "  try texts of 100 MB too, and see that time grows as they do" );
  ]

(* {1 Small texts} *)

(* Larger scenes would take all of the time. *)
let most_bytes = 4096

let gallery () =
  let read name =
    let path = Filename.concat !folder name in
    In_channel.with_open_bin path In_channel.input_all
  in
  Sys.readdir !folder |> Array.to_list |> List.sort String.compare
  |> List.filter (fun name -> Filename.extension name = ".scene")
  |> List.map read
  |> List.filter (fun text -> String.length text <= most_bytes)

let kinds = lazy (Array.of_list (Case.kinds ~gallery:(gallery ())))

(* A case is made from nothing but the seed and its number. *)
let case number =
  let kinds = Lazy.force kinds in
  let name, make = kinds.(number mod Array.length kinds) in
  (name, make (Random.State.make [| !seed; number |]))

let failures = Atomic.make 0

let fail name complaint =
  Atomic.incr failures;
  Printf.printf "%s: %s\n%!" name complaint

let try_case number =
  let kind, text = case number in
  let complain complaint =
    fail
      (Printf.sprintf "case %d of seed %d, %s" number !seed kind)
      (complaint ^ ": " ^ String.escaped text)
  in
  Option.iter complain (Oracle.complaint text)

let batch = 250

let try_all () =
  let try_batch () k =
    for number = k * batch to Int.min !cases ((k + 1) * batch) - 1 do
      try_case number
    done
  in
  ignore (Lazy.force kinds);
  let domains = Parallel.default_domains () in
  ignore
    (Parallel.iter ~domains ~worker:ignore
       ~count:((!cases + batch - 1) / batch)
       try_batch);
  Printf.printf "%d cases of seed %d\n%!" !cases !seed

(* {1 Large texts} *)

let bytes_allocated () = Gc.allocated_bytes ()

let try_large n =
  let try_one (name, make) =
    Option.iter (fail name) (Oracle.complaint (make n));
    (* counted, not timed: the same on any machine *)
    let growth = Large.growth ~measure:bytes_allocated make (n / 4) in
    if growth > 5. then
      fail name
        (Printf.sprintf "4 times the size takes %.1f times the memory" growth)
  in
  List.iter try_one Large.texts;
  Printf.printf "%d large texts of %d times the same\n%!"
    (List.length Large.texts) n

let try_very_large () =
  let try_one (name, make) =
    let unit = String.length (make 1001) - String.length (make 1000) in
    let n = 100_000_000 / unit in
    (match Oracle.complaint (make (Int.min n 5_000_000)) with
    | None -> ()
    | Some complaint -> fail name complaint);
    let growth = Large.growth ~measure:Sys.time make (n / 4) in
    Printf.printf "%s, 100 MB: 4 times the size takes %.1f times the time\n%!"
      name growth;
    if growth > 8. then fail name "its time grows faster than the text"
  in
  List.iter try_one Large.texts

(* {1 Programs that ask for too much} *)

(* 20 million elements of a list or objects, and what the collector leaves. *)
let most_bytes_held = 3_000_000_000

let try_greedy texts =
  let try_one (name, text) =
    Option.iter (fail name) (Oracle.complaint_unless_error text);
    Gc.compact ()
  in
  List.iter try_one texts;
  let held = (Gc.quick_stat ()).top_heap_words * (Sys.word_size / 8) in
  if held > most_bytes_held then
    fail "greedy programs" (Printf.sprintf "they take %d bytes" held);
  Printf.printf "%d greedy programs\n%!" (List.length texts)

let () =
  Arg.parse (Arg.align options)
    (fun word -> raise (Arg.Bad ("what is " ^ word ^ "?")))
    "fuzz [OPTION]...";
  if !only >= 0 then (
    let _, text = case !only in
    print_endline text;
    try_case !only)
  else (
    try_greedy (if !long then Greedy.texts @ Greedy.slow else Greedy.texts);
    try_all ();
    try_large 100_000;
    if !long then try_very_large ());
  if Atomic.get failures > 0 then exit 1
