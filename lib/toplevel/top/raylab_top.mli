(** A toplevel for raylab. Linking this module is enough: the words and modules
    of {!Raylab_toplevel.Prelude} are then there at the first prompt, and utop
    finds its printers. *)
