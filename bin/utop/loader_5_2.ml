open Persistent_env.Persistent_signature

let install () =
  let load_file = !load in
  load :=
    fun ~allow_hidden ~unit_name ->
      match Interface.find unit_name with
      | Some cmi ->
          let filename = cmi.cmi_name ^ ".cmi" in
          Some { filename; cmi; visibility = Visible }
      | None -> load_file ~allow_hidden ~unit_name
