(* states GRAMMAR.cmly: an OCaml module that says of each state of the parser
   which productions it is in the middle of. *)

module Grammar = MenhirSdk.Cmly_read.Read (struct
  let filename = Sys.argv.(1)
end)

open Grammar

let symbol (symbol, _, _) =
  match symbol with
  | T t -> Terminal.name t
  | N n -> Nonterminal.mangled_name n

let item (production, dot) =
  let before = Array.sub (Production.rhs production) 0 dot
  and after =
    Array.sub
      (Production.rhs production)
      dot
      (Array.length (Production.rhs production) - dot)
  in
  let list symbols =
    String.concat "; "
      (List.map
         (fun s -> Printf.sprintf "%S" (symbol s))
         (Array.to_list symbols))
  in
  Printf.sprintf "{ whole = %S; before = [ %s ]; after = [ %s ] }"
    (Nonterminal.mangled_name (Production.lhs production))
    (list before) (list after)

let () =
  print_endline
    "type item = { whole : string; before : string list; after : string list }";
  print_endline "let items = [|";
  Lr1.iter (fun state ->
      Printf.printf "[ %s ];\n"
        (String.concat "; " (List.map item (Lr0.items (Lr1.lr0 state)))));
  print_endline "|]"
