let entries : (Path.kind * string) list =
  [
    (Primary, "from the eye");
    (Mirrored, "mirrored");
    (Lit 0, "shadow ray to a light");
    (Blocked 0, "shadow ray, blocked");
  ]

let entry_width = 190.
let width = entry_width *. float_of_int (List.length entries)

let draw (x, y) =
  let entry i (kind, words) =
    let x = x +. (entry_width *. float_of_int i) in
    let b = (x +. 34., y) in
    Svg.line ~style:(Stroke.style kind) (x, y) b
    :: (match kind with Blocked _ -> Stroke.cross b | _ -> [])
    @ [ Svg.text ~size:11. (x +. 48., y +. 4.) words ]
  in
  List.concat (List.mapi entry entries)
