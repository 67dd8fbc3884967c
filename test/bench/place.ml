let absolute path =
  if Filename.is_relative path then Filename.concat (Sys.getcwd ()) path
  else path

let here = Filename.dirname (absolute Sys.executable_name)
let beside path = List.fold_left Filename.concat here path
let up = Filename.parent_dir_name
let raylab = beside [ up; up; "bin"; "main.exe" ]
let first_scene = beside [ up; up; "scenes"; "first.scene" ]
let sphereflake = beside [ up; up; "scenes"; "sphereflake.scene" ]
