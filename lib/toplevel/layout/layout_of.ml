(* layout_of FILE.ml... prints a module with a digest of what is in these files:
   of all that says how a scene lies in memory. *)

let () =
  Array.to_list Sys.argv |> List.tl |> List.map Digest.file |> String.concat ""
  |> Digest.string |> Digest.to_hex
  |> Printf.printf "let digest = %S\n"
