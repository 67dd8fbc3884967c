type t = Save | Render | Toggle_path | Clear | Help | Close

let of_char c =
  (* in upper case with Caps Lock *)
  match Char.lowercase_ascii c with
  | 's' -> Some Save
  | 'r' -> Some Render
  | 'e' -> Some Toggle_path
  | 'c' -> Some Clear
  | 'h' -> Some Help
  | 'q' | '\027' -> Some Close
  | _ -> None

let help =
  {|click  explain a pixel: here, and by the path of its rays in the window
s      save the picture
r      render the scene file again
e      show the path or hide it
c      clear the path
h      list the keys
q      close the window; Escape, too|}
