open Raylab_drawing

(* [after count line] is where in [line], which is UTF-8, its first [count]
   characters end; [None] if it has no more. *)
let after count line =
  let rec go count at =
    if at >= String.length line then None
    else if count = 0 then Some at
    else
      let decoded = String.get_utf_8_uchar line at in
      go (count - 1) (at + Uchar.utf_decode_length decoded)
  in
  go count 0

(* at blanks, where there are any *)
let rec break columns line =
  match after columns line with
  | None -> [ line ]
  | Some end_ ->
      let first, rest =
        match String.rindex_from_opt line end_ ' ' with
        | Some blank when blank > 0 -> (blank, blank + 1)
        | _ -> (end_, end_)
      in
      String.sub line 0 first
      :: break columns (String.sub line rest (String.length line - rest))

let wrap ~columns ~rows text =
  if columns < 1 || rows < 1 then []
  else
    let lines =
      List.concat_map (break columns) (String.split_on_char '\n' text)
    in
    if List.compare_length_with lines rows <= 0 then lines
    else List.filteri (fun k _ -> k < rows - 1) lines @ [ "..." ]

let white = 0xffffff
let margin = 10.
let leading = 2.

let draw ~text_size { Rectangle.left; top; right; bottom } text =
  let across, down = text_size "X" in
  let down = down +. leading in
  let count length each =
    int_of_float ((length -. (2. *. margin)) /. Float.max 1. each)
  in
  let lines =
    wrap text
      ~columns:(count (right -. left) across)
      ~rows:(count (bottom -. top) down)
  in
  List.mapi
    (fun k line ->
      let top = top +. margin +. (float_of_int k *. down) in
      Drawing.text ~level:Top ~ink:white (left +. margin, top) line)
    lines
