open Raylab_geometry
open Raylab_scene
open Raylab_tracer
open Raylab_explanation

(* In pixels. *)
let widest = 1120.
let highest = 560.
let gap = 20.
let caption = 22.
let text_line = 18.
let character = 7.

(* [wrap width sentence] is its words in lines that fit into [width] pixels. *)
let wrap width sentence =
  let longest = int_of_float (width /. character) in
  let add lines word =
    match lines with
    | line :: rest when String.length line + String.length word < longest ->
        (line ^ " " ^ word) :: rest
    | _ -> word :: lines
  in
  List.rev (List.fold_left add [] (String.split_on_char ' ' sentence))

(* {1 The panels} *)

let panels (space : Box3.t) =
  let { Vec3.x; y; z } = Vec3.sub space.high space.low in
  let scale =
    Float.min ((widest -. (3. *. gap)) /. (x +. z)) (highest /. Float.max z y)
  in
  let panel side left width height =
    { Panel.side; left; top = 0.; width; height; scale; space }
  in
  let above = panel Above gap (scale *. x) (scale *. z) in
  let left = above.left +. above.width +. gap in
  (above, panel Beside left (scale *. z) (scale *. y))

(* The longest of 1, 2, 5, 10 ... that is at most a quarter of the panel. *)
let round_length longest =
  let power = 10. ** Float.floor (Float.log10 longest) in
  let fits k = k *. power <= longest in
  power *. if fits 5. then 5. else if fits 2. then 2. else 1.

let scale_bar (panel : Panel.t) =
  let length = round_length (0.25 *. panel.width /. panel.scale) in
  let y = panel.top +. panel.height -. 10. and x = panel.left +. 10. in
  let right = x +. (length *. panel.scale) in
  Sketch.all
    [
      Sketch.busy
        { Rectangle.left = x; right; top = y -. 4.; bottom = y +. 4. }
        [ Line (Drawing.stroke ~width:2. 0x444444, (x, y), (right, y)) ];
      Sketch.label
        (Label.make ~size:11. ~reach:0.
           [ (right +. 5., y +. 4.) ]
           (Words.number length));
    ]

let paper =
  Drawing.filled ~outline:(Drawing.stroke ~width:1. 0xbbbbbb) (Ink 0xfafafa)

let panel_parts name words (scene : Scene.t) path (panel : Panel.t) =
  let scenery, numbers = Scenery.draw panel scene path in
  let shown = Rays.lights_shown path in
  let sketch =
    Sketch.all
      [
        scale_bar panel;
        scenery;
        Rays.draw panel path;
        Light_marks.draw panel ~shown scene.lights;
        numbers;
      ]
  and box = Panel.box panel in
  [
    Sheet.Free [ Drawing.text ~size:13. (panel.left, panel.top -. 7.) words ];
    Panel { name; box; paper; drawing = Sketch.finish box sketch };
  ]

(* {1 The sheet} *)

let rays ?sample (pixel : Explain.pixel) =
  match sample with
  | Some k -> [ (List.nth pixel.samples (k - 1)).ray ]
  | None -> Group.rays pixel

let make ?sample scene pixel =
  let title = Summary.of_pixel pixel in
  let path = Path.of_rays pixel.film (rays ?sample pixel) in
  let above, beside = panels (Extent.of_path scene path) in
  let width =
    Float.max
      (beside.left +. beside.width +. gap)
      (Legend.width path +. (2. *. gap))
  in
  let lines = wrap (width -. (2. *. gap)) title in
  let top =
    gap +. (text_line *. float_of_int (List.length lines)) +. caption
  in
  let panel name words panel =
    panel_parts name words scene path { panel with Panel.top }
  in
  let bottom = top +. Float.max above.height beside.height in
  let line i =
    Drawing.text ~size:13. (gap, gap +. (text_line *. float_of_int i))
  in
  {
    Sheet.width;
    height = bottom +. (2.5 *. gap);
    title;
    parts =
      Sheet.Free (List.mapi line lines)
      :: panel "above" "from above: x to the right, z up" above
      @ panel "beside" "from the side: z to the right, y up" beside
      @ [ Free (Legend.in_line path (gap, bottom +. (1.4 *. gap))) ];
  }

let to_svg ?sample scene pixel = Svg.document (make ?sample scene pixel)
