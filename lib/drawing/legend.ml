let kinds = [ Path.Primary; Mirrored; Lit; Blocked ]
let entry_width = 190.
let width = entry_width *. float_of_int (List.length kinds)

let in_line (x, y) =
  let entry i kind =
    let x = x +. (entry_width *. float_of_int i) in
    let b = (x +. 34., y) in
    Ray_look.line Paper kind (x, y) b
    @ (if kind = Path.Blocked then Ray_look.cross Paper b else [])
    @ [
        Drawing.text ~size:11. (x +. 48., y +. 4.) (Ray_look.words Paper kind);
      ]
  in
  List.concat (List.mapi entry kinds)
