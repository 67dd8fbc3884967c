type t =
  | Save
  | Render
  | Toggle_path
  | Clear
  | Nearer
  | Farther
  | Back
  | Print_view
  | Help
  | Close

let of_char c =
  (* in upper case with Caps Lock *)
  match Char.lowercase_ascii c with
  | 's' -> Some Save
  | 'r' -> Some Render
  | 'e' -> Some Toggle_path
  | 'c' -> Some Clear
  (* many keyboards have + above = *)
  | '+' | '=' -> Some Nearer
  | '-' -> Some Farther
  | '0' -> Some Back
  | 'v' -> Some Print_view
  | 'h' -> Some Help
  | 'q' | '\027' -> Some Close
  | _ -> None

let help =
  {|click  explain a pixel, in words and by the path of its rays
drag   turn the eye around the point that it looks at
+ -    nearer, farther
0      back to the view of the scene
v      print the settings of this view, to be put into the scene
s      save the picture
r      render the scene file again
e      show words and path of the pixel, or hide them
c      clear them
h      list the keys
q      close the window; Escape, too|}
