open Raylab_scene

type t = string * int

let sentence (word, offset) =
  let text =
    Printf.sprintf
      "'%s' is a name from here to the end of its block, and no longer the \
       word of the language"
      word
  in
  { Warning.text; about = [ Literal offset ] }

let warnings taken = Warning.few "name" sentence taken
