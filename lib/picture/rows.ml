type t = first:int -> count:int -> bytes

let of_bytes ~width ~top rgb ~first ~count =
  let row = 3 * width in
  Bytes.sub rgb ((first - top) * row) (count * row)

let piece_bytes = 1 lsl 20

let pieces ~width ~first ~last =
  let most = Int.max 1 (piece_bytes / 3 / width) in
  let next first =
    if first > last then None
    else
      let count = Int.min most (last - first + 1) in
      Some ((first, count), first + count)
  in
  Seq.unfold next first

let iter ~lowest_first ~width ~first ~last f rows =
  let pieces = List.of_seq (pieces ~width ~first ~last) in
  List.iter
    (fun (first, count) -> f (rows ~first ~count))
    (if lowest_first then List.rev pieces else pieces)
