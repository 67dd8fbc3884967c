open Raylab_source

let find ~from name =
  let path = Access.join ~from name in
  if Sys.file_exists path then Ok { Access.path; identity = path }
  else Access.refuse "no such file"

let read ~limit:_ { Access.path; _ } =
  Ok (In_channel.with_open_bin path In_channel.input_all)

let access path = { Access.main = Some path; find; read }
