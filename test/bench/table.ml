let widths rows =
  List.fold_left
    (List.map2 (fun width cell -> Int.max width (String.length cell)))
    (List.map String.length (List.hd rows))
    (List.tl rows)

let pad ~left width cell =
  let space = String.make (width - String.length cell) ' ' in
  if left then cell ^ space else space ^ cell

let line cells = "| " ^ String.concat " | " cells ^ " |\n"

let to_string ~header rows =
  let widths = widths (header :: rows) in
  let row cells =
    line
      (List.mapi
         (fun k (width, cell) -> pad ~left:(k = 0) width cell)
         (List.combine widths cells))
  in
  let rule =
    line
      (List.mapi
         (fun k width ->
           let dashes = String.make (Int.max 2 (width - 1)) '-' in
           if k = 0 then "-" ^ dashes else dashes ^ ":")
         widths)
  in
  String.concat "" (row header :: rule :: List.map row rows)
