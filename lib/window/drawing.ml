let background = 0x202428
let rim = 0x101010
let white = 0xffffff

let picture canvas raster look { Box.top; height; _ } =
  Canvas.paint canvas ~left:0 ~top (Raster.rows raster look ~top ~height)

let nothing canvas = Canvas.fill canvas ~color:background

(* {1 The path} *)

(* Everything is drawn twice, first wider and dark, so that it can be seen on
   any picture. *)
let strokes canvas role segment =
  let dashed = Path_overlay.is_dashed role in
  let parts = if dashed then Segment.dashes segment else [ segment ] in
  let width = if dashed then 1 else 2 in
  let draw color width = List.iter (Canvas.line canvas ~color ~width) parts in
  draw rim (width + 2);
  draw (Path_overlay.color role) width

let ray canvas layout (role, (a, b)) =
  let segment = (Layout.place layout a, Layout.place layout b) in
  Option.iter (strokes canvas role)
    (Segment.clip (Layout.window layout) segment)

(* Places far outside have no coordinates that X can hold. *)
let is_inside layout (x, y) =
  let { Box.width; height; _ } = Layout.window layout in
  0. <= x && x <= float_of_int width && 0. <= y && y <= float_of_int height

let mark layout draw point =
  let point = Layout.place layout point in
  if is_inside layout point then draw point

let hit canvas point =
  Canvas.disc canvas ~color:rim ~radius:4 point;
  Canvas.disc canvas ~color:(Path_overlay.color Mirrored) ~radius:3 point

let cross canvas (x, y) =
  let arm dy = ((x -. 5., y -. dy), (x +. 5., y +. dy)) in
  let draw color width =
    List.iter (fun dy -> Canvas.line canvas ~color ~width (arm dy)) [ 5.; -5. ]
  in
  draw rim 4;
  draw (Path_overlay.color Blocked) 2

(* The pixel itself: a ring around it. *)
let target canvas layout (x, y) =
  let corner dx dy =
    Layout.place layout (float_of_int (x + dx), float_of_int (y + dy))
  in
  let left, top = corner 0 0 and right, bottom = corner 1 1 in
  let away = 6. in
  let left = left -. away and top = top -. away in
  let right = right +. away -. 1. and bottom = bottom +. away -. 1. in
  let sides =
    [
      ((left, top), (right, top));
      ((right, top), (right, bottom));
      ((right, bottom), (left, bottom));
      ((left, bottom), (left, top));
    ]
  in
  let draw color width =
    List.iter
      (fun side ->
        Option.iter
          (Canvas.line canvas ~color ~width)
          (Segment.clip (Layout.window layout) side))
      sides
  in
  draw rim 3;
  draw white 1

let legend canvas layout roles =
  let widest =
    List.fold_left
      (fun widest role ->
        Int.max widest (fst (Canvas.text_size canvas (Path_overlay.name role))))
      0 roles
  and _, line = Canvas.text_size canvas "X" in
  let swatch = 26 and margin = 6 in
  let { Box.height = window_height; width = window_width; _ } =
    Layout.window layout
  in
  let width = (3 * margin) + swatch + widest
  and height = (2 * margin) + (List.length roles * (line + 3)) in
  if roles <> [] && width <= window_width && 3 * height <= window_height then (
    let top = window_height - height in
    Canvas.fill canvas ~color:background { left = 0; top; width; height };
    List.iteri
      (fun k role ->
        let top = top + margin + (k * (line + 3)) in
        let y = float_of_int (top + (line / 2)) in
        let x = float_of_int margin in
        strokes canvas role ((x, y), (x +. float_of_int swatch, y));
        Canvas.text canvas ~color:white
          ~left:((2 * margin) + swatch)
          ~top (Path_overlay.name role))
      roles)

let path canvas layout ~pixel (overlay : Path_overlay.t) =
  List.iter (ray canvas layout) overlay.lines;
  List.iter (mark layout (hit canvas)) overlay.hits;
  List.iter (mark layout (cross canvas)) overlay.blocks;
  target canvas layout pixel;
  legend canvas layout (Path_overlay.roles overlay)

(* {1 Messages} *)

let message canvas layout text =
  let { Box.width; height; _ } = Layout.window layout in
  let across, down = Canvas.text_size canvas "X" in
  let margin = 10 and down = down + 2 in
  let lines =
    Text.wrap text
      ~columns:((width - (2 * margin)) / Int.max 1 across)
      ~rows:((height - (2 * margin)) / down)
  in
  List.iteri
    (fun k line ->
      Canvas.text canvas ~color:white ~left:margin
        ~top:(margin + (k * down))
        line)
    lines
