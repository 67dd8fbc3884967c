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

(* A letter's width, and the height of a line. *)
let cell text_size =
  let across, down = text_size "X" in
  (Float.max 1. across, Float.max 1. (down +. leading))

let fitting ~text_size ~margin width height text =
  let across, down = cell text_size in
  let count length each = int_of_float ((length -. (2. *. margin)) /. each) in
  wrap text ~columns:(count width across) ~rows:(count height down)

let write ~text_size ~margin (left, top) lines =
  let _, down = cell text_size in
  List.mapi
    (fun k line ->
      let top = top +. margin +. (float_of_int k *. down) in
      Drawing.text ~level:Top ~ink:white (left +. margin, top) line)
    lines

let draw ~text_size { Rectangle.left; top; right; bottom } text =
  fitting ~text_size ~margin (right -. left) (bottom -. top) text
  |> write ~text_size ~margin (left, top)

(* {1 Notes} *)

let paper = Drawing.filled (Ink 0x202428)
let inset = 6.

let note ~text_size ?avoid ({ Rectangle.left; top; right; bottom } as window)
    text =
  let lines =
    fitting ~text_size ~margin:inset (right -. left)
      ((bottom -. top) /. 2.)
      text
  in
  let _, down = cell text_size in
  let height =
    (float_of_int (List.length lines) *. down) +. (2. *. inset) -. leading
  in
  let at_top = { window with bottom = top +. height }
  and at_bottom = { window with top = bottom -. height } in
  let is_in_the_way =
    Option.fold ~none:false ~some:(Rectangle.overlap at_top)
  in
  let box, rest =
    if is_in_the_way avoid then
      (at_bottom, { window with bottom = at_bottom.top })
    else (at_top, { window with top = at_top.bottom })
  in
  if lines = [] then (window, [])
  else
    ( rest,
      Drawing.Box (paper, box)
      :: write ~text_size ~margin:inset (box.left, box.top) lines )
