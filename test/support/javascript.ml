let here =
  match Sys.backend_type with
  | Other "js_of_ocaml" -> true
  | Other _ | Native | Bytecode -> false
