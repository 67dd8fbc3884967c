open Persistent_env.Persistent_signature

let install () =
  let load_file = !load in
  load :=
    fun ~unit_name ->
      match Interface.find unit_name with
      | Some cmi -> Some { filename = cmi.cmi_name ^ ".cmi"; cmi }
      | None -> load_file ~unit_name
