open Raylab_geometry
open Raylab_scene
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

let panels (frame : Frame.t) =
  let { Vec3.x; y; z } = Vec3.sub frame.high frame.low in
  let scale =
    Float.min ((widest -. (3. *. gap)) /. (x +. z)) (highest /. Float.max z y)
  in
  let panel side left width height =
    { View.side; left; top = 0.; width; height; scale; frame }
  in
  let above = panel Above gap (scale *. x) (scale *. z) in
  let left = above.left +. above.width +. gap in
  (above, panel Beside left (scale *. z) (scale *. y))

(* The longest of 1, 2, 5, 10 ... that is at most a quarter of the panel. *)
let round_length longest =
  let power = 10. ** Float.floor (Float.log10 longest) in
  let fits k = k *. power <= longest in
  power *. if fits 5. then 5. else if fits 2. then 2. else 1.

let scale_bar (view : View.t) =
  let length = round_length (0.25 *. view.width /. view.scale) in
  let y = view.top +. view.height -. 10. and x = view.left +. 10. in
  let right = x +. (length *. view.scale) in
  Drawn.all
    [
      Drawn.mark
        { Rectangle.left = x; right; top = y -. 4.; bottom = y +. 4. }
        [
          Svg.line ~style:{|stroke="#444" stroke-width="2"|} (x, y) (right, y);
        ];
      Drawn.label
        (Label.make ~size:11. ~reach:0.
           [ (right +. 5., y +. 4.) ]
           (Words.number length));
    ]

let draw_panel ~name words (scene : Scene.t) e (view : View.t) =
  let corner = (view.left, view.top) in
  let { View.width; height; _ } = view in
  let scenery, numbers = Scenery.draw view scene e in
  let shown = Route.directional_lights e in
  let drawn =
    Drawn.all
      [
        scale_bar view;
        scenery;
        Route.draw view e;
        Light_marks.draw view ~shown scene.lights;
        numbers;
      ]
  in
  [
    Svg.text ~size:13. (view.left, view.top -. 7.) words;
    Svg.clip_box ~name corner ~width ~height;
    Svg.box ~style:{|fill="#fafafa" stroke="#bbb"|} corner ~width ~height;
    Svg.group ~clip:name (Drawn.draw view drawn);
  ]

let to_svg ?pixel scene e =
  let above, beside = panels (Frame.fit scene e) in
  let width =
    Float.max (beside.left +. beside.width +. gap) (Legend.width +. (2. *. gap))
  in
  let sentence = Summary.to_string ?pixel e in
  let lines = wrap (width -. (2. *. gap)) sentence in
  let top =
    gap +. (text_line *. float_of_int (List.length lines)) +. caption
  in
  let panel name words view =
    draw_panel ~name words scene e { view with View.top }
  in
  let bottom = top +. Float.max above.height beside.height in
  let sentence_line i line =
    Svg.text ~size:13. (gap, gap +. (text_line *. float_of_int i)) line
  in
  Svg.document ~width
    ~height:(bottom +. (2.5 *. gap))
    ~title:sentence
    (List.mapi sentence_line lines
    @ panel "above" "from above: x to the right, z up" above
    @ panel "beside" "from the side: z to the right, y up" beside
    @ Legend.draw (gap, bottom +. (1.4 *. gap)))
