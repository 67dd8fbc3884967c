(* The line at the first byte of each block of [block] bytes is known; from
   there on one looks. *)
let block = 4096

type line = { number : int; start : int; stop : int }
type t = { text : string; blocks : line array }

let line_end text ~from =
  match String.index_from_opt text from '\n' with
  | Some stop -> stop
  | None -> String.length text

(* The line at [offset], of which [line] is one before or the same. Looks at the
   bytes from [from] on, where [line] still is. *)
let rec advance text line ~from offset =
  if from >= offset then line
  else if text.[from] = '\n' then
    let start = from + 1 in
    let next = { number = line.number + 1; start; stop = -1 } in
    advance text next ~from:start offset
  else advance text line ~from:(from + 1) offset

let with_stop text line ~from =
  if line.stop >= 0 then line else { line with stop = line_end text ~from }

let index text =
  let line = ref { number = 0; start = 0; stop = line_end text ~from:0 } in
  let block_line k =
    let from = Int.max 0 ((k - 1) * block) and offset = k * block in
    line := with_stop text (advance text !line ~from offset) ~from:offset;
    !line
  in
  { text; blocks = Array.init ((String.length text / block) + 1) block_line }

let at { text; blocks } offset =
  let k = offset / block in
  let line = advance text blocks.(k) ~from:(k * block) offset in
  if line.stop >= 0 then line
  else
    (* the end is in this block, or is that of the line at the next one *)
    let next = (k + 1) * block in
    let rec find i =
      if i >= String.length text then i
      else if i = next then blocks.(k + 1).stop
      else if text.[i] = '\n' then i
      else find (i + 1)
    in
    { line with stop = find offset }
