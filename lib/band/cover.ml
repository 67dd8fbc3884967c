type 'a piece = { part : 'a; first : int; last : int }

let pieces ~height bands =
  let add (next, pieces, missing) ({ first; last; _ } as band) =
    let missing =
      if first > next then (next, first - 1) :: missing else missing
    in
    if last < next then (next, pieces, missing)
    else (last + 1, { band with first = Int.max next first } :: pieces, missing)
  in
  let by_first a b = Int.compare a.first b.first in
  let next, pieces, missing =
    List.fold_left add (0, [], []) (List.stable_sort by_first bands)
  in
  let missing =
    if next < height then (next, height - 1) :: missing else missing
  in
  (List.rev pieces, List.rev missing)

let within ~first ~last pieces =
  List.filter_map
    (fun piece ->
      let first = Int.max first piece.first
      and last = Int.min last piece.last in
      if first <= last then Some { piece with first; last } else None)
    pieces
