(* The line at the first byte of each block of [block] bytes is known; from
   there on one looks. *)
let block = 4096

type line = { number : int; start : int; stop : int }
type t = { text : string; blocks : line array }

(* Whether a line follows the byte at [i]. Of CR LF it follows the LF. *)
let ends_line text i =
  match text.[i] with
  | '\n' -> true
  | '\r' -> i + 1 = String.length text || text.[i + 1] <> '\n'
  | _ -> false

(* The line end that is at or after [i], before [limit], or else [limit]. *)
let rec find_end text i limit =
  if i >= limit || text.[i] = '\n' || text.[i] = '\r' then i
  else find_end text (i + 1) limit

(* One may start to look for an end in the middle of it. *)
let start_of_end text i =
  if 0 < i && i < String.length text && text.[i] = '\n' && text.[i - 1] = '\r'
  then i - 1
  else i

let line_end text ~from =
  start_of_end text (find_end text from (String.length text))

(* The line at [offset], of which [line] is one before or the same. Looks at the
   bytes from [from] on, where [line] still is. *)
let rec advance text line ~from offset =
  if from >= offset then line
  else if ends_line text from then
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
    let stop = find_end text offset (Int.min next (String.length text)) in
    let stop =
      if stop = next then blocks.(k + 1).stop else start_of_end text stop
    in
    { line with stop }
