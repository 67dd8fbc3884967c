(* embed FILE.cmi... prints a module with the contents of these files. They are
   read here, for the compiler reads them from files only. *)

let () =
  print_string "let interfaces =\n  [\n";
  List.iter
    (fun file ->
      let cmi = Cmi_format.read_cmi file in
      Printf.printf "    (%S, %S);\n" cmi.cmi_name (Marshal.to_string cmi []))
    (List.tl (Array.to_list Sys.argv));
  print_string "  ]\n"
