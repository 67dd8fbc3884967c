let () =
  Clflags.open_modules := "Raylab_toplevel.Prelude" :: !Clflags.open_modules
