let kinds { Path.rays; _ } =
  let is_refracted { Path.kind; _ } = kind = Refracted in
  [ Path.Primary; Mirrored ]
  @ (if List.exists is_refracted rays then [ Path.Refracted ] else [])
  @ [ Lit; Blocked ]

let entry_width = 190.
let width path = entry_width *. float_of_int (List.length (kinds path))

let in_line path (x, y) =
  let entry i kind =
    let x = x +. (entry_width *. float_of_int i) in
    let b = (x +. 34., y) in
    Ray_look.line Paper kind (x, y) b
    @ (if kind = Path.Blocked then Ray_look.cross Paper b else [])
    @ [
        Drawing.text ~size:11. (x +. 48., y +. 4.) (Ray_look.words Paper kind);
      ]
  in
  List.concat (List.mapi entry (kinds path))

let paper = Drawing.filled (Ink 0x202428)
let margin = 6.
let sample = 26.

let in_corner ~text_size { Rectangle.left; top; right; bottom } kinds =
  let words = Ray_look.words Picture in
  let widest =
    List.fold_left
      (fun widest kind -> Float.max widest (fst (text_size (words kind))))
      0. kinds
  and _, line = text_size "X" in
  let entry_height = line +. 3. in
  let width = (3. *. margin) +. sample +. widest
  and height =
    (2. *. margin) +. (float_of_int (List.length kinds) *. entry_height)
  in
  let first = bottom -. height in
  let entry k kind =
    let top = first +. margin +. (float_of_int k *. entry_height)
    and x = left +. margin in
    let y = top +. Float.floor (line /. 2.) in
    Ray_look.line Picture kind (x, y) (x +. sample, y)
    @ [
        Drawing.text ~level:Top ~ink:0xffffff
          (x +. sample +. margin, top)
          (words kind);
      ]
  in
  let is_room = width <= right -. left && 3. *. height <= bottom -. top in
  if kinds = [] || not is_room then []
  else
    let box = { Rectangle.left; top = first; right = left +. width; bottom } in
    Drawing.Box (paper, box) :: List.concat (List.mapi entry kinds)
