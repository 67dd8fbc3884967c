(* save FILE writes "new" there, and prints what became of that. Test_fixed runs
   it where a file cannot be replaced. *)

open Raylab_picture

let write channel = output_string channel "new"

let () =
  let path = Sys.argv.(1) in
  match Atomic_file.save ~path write with
  | Ok outcome -> print_string (Atomic_file.wrote ~path outcome)
  | Error message -> print_string message
