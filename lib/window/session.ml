open Raylab_scene
open Raylab_tracer
open Raylab_drawing

type source = {
  name : string;
  load : unit -> (Scene.t, string) result;
  can_save : unit -> (unit, string) result;
  save : Picture.t -> string;
}

type path = { pixel : int * int; overlay : Overlay.t; visible : bool }

type t = {
  source : source;
  terminal : Terminal.t;
  domains : int;
  rows : Render.rows option;
  screen : (int * int) option;
  canvas : Canvas.t;
  mutable layout : Layout.t;
  mutable raster : Raster.t;
  mutable picture_size : int * int;
  mutable stage : Stage.t;
  mutable current : Shown.t option;  (** the last that was begun *)
  mutable whole : Shown.t option;  (** the last that became whole *)
  mutable path : path option;
  mutable save_when_whole : bool;
  mutable rendering : Rendering.t option;
  mutable render_again : bool;
  mutable damage : Box.t;  (** what is to be drawn anew *)
}

let lay_out canvas picture =
  let layout = Layout.make ~window:(Canvas.size canvas) ~picture in
  (layout, Raster.make layout ~background:Painter.background)

let make ~domains ?rows ~terminal ~screen ~picture source canvas =
  let layout, raster = lay_out canvas picture in
  {
    source;
    terminal;
    domains;
    rows;
    screen;
    canvas;
    layout;
    raster;
    picture_size = picture;
    stage = Reading;
    current = None;
    whole = None;
    path = None;
    save_when_whole = false;
    rendering = None;
    render_again = false;
    damage = Layout.window layout;
  }

let draw_all s = s.damage <- Layout.window s.layout

let lay_out_again s =
  let layout, raster = lay_out s.canvas s.picture_size in
  s.layout <- layout;
  s.raster <- raster;
  draw_all s

(* What a click is about, and what is saved. *)
let in_view s =
  match s.stage with In_error _ | Reading -> s.whole | _ -> s.current

(* {1 What is shown} *)

let look s =
  let is_seen shown =
    Shown.size shown = s.picture_size && Refinement.part shown.refinement > 0.
  in
  let of_first some =
    match List.filter is_seen (List.filter_map Fun.id some) with
    | [] -> None
    | seen -> Some (Shown.look seen)
  in
  match s.stage with
  | In_error _ -> Option.map Raster.dim (of_first [ s.whole ])
  | Reading -> of_first [ s.whole ]
  | Rendering | Took _ -> of_first [ s.current; s.whole ]

let title s =
  let part =
    match s.current with
    | None -> 0.
    | Some { refinement; _ } -> Refinement.part refinement
  in
  Stage.title s.stage ~name:s.source.name ~size:s.picture_size ~part

let path_drawing { canvas; layout; _ } { pixel; overlay; _ } =
  let window = Box.rectangle (Layout.window layout)
  and text_size words =
    let width, height = Canvas.text_size canvas words in
    (float_of_int width, float_of_int height)
  in
  Overlay.draw ~place:(Layout.place layout) window ~pixel overlay
  @ Legend.in_corner ~text_size window (Overlay.kinds overlay)

let draw s =
  Canvas.set_title s.canvas (title s);
  let damage = Box.inter s.damage (Layout.window s.layout) in
  if not (Box.is_empty damage) then (
    (match look s with
    | None -> Painter.nothing s.canvas damage
    | Some look -> Painter.picture s.canvas s.raster look damage);
    (match (s.stage, s.path) with
    | In_error message, _ -> Painter.message s.canvas s.layout message
    | _, Some ({ visible = true; _ } as path) ->
        Painter.drawing s.canvas (path_drawing s path)
    | _ -> ());
    Canvas.show s.canvas;
    s.damage <- { left = 0; top = 0; width = 0; height = 0 })

(* {1 Clicks} *)

let path_of shown pixel explanation ~visible =
  { pixel; overlay = Shown.overlay shown explanation; visible }

let click s place =
  match (in_view s, Layout.pixel s.layout place) with
  | Some shown, Some pixel when Shown.size shown = s.picture_size ->
      let e = Shown.explain shown pixel in
      s.terminal.explain e;
      s.path <- Some (path_of shown pixel e ~visible:true);
      draw_all s
  | _ -> ()

(* The pixel that was asked about stays the same when the scene changes. *)
let follow_path s shown =
  let width, height = s.picture_size in
  match s.path with
  | Some { pixel = (x, y) as pixel; visible; _ } when x < width && y < height
    ->
      s.path <- Some (path_of shown pixel (Shown.explain shown pixel) ~visible)
  | _ -> s.path <- None

(* {1 Rendering} *)

let save s =
  match (s.stage, s.whole) with
  | Took _, Some { refinement; _ } ->
      s.terminal.tell (s.source.save (Refinement.picture refinement))
  | In_error _, _ ->
      s.terminal.tell "the scene is in error: there is no picture to save"
  | _ -> (
      match s.source.can_save () with
      | Error message -> s.terminal.tell message
      | Ok () ->
          s.save_when_whole <- true;
          s.terminal.tell "the picture will be saved when it is whole")

let note_size s size =
  if size <> s.picture_size then (
    s.picture_size <- size;
    let width, height = Layout.window_size ~screen:s.screen size in
    Canvas.resize s.canvas ~width ~height;
    lay_out_again s)

let become_whole s shown seconds =
  s.whole <- Some shown;
  s.stage <- Took seconds;
  if s.save_when_whole then (
    s.save_when_whole <- false;
    save s)

let begin_ s (shown : Shown.t) =
  s.stage <- Rendering;
  s.current <- Some shown;
  note_size s (Shown.size shown);
  follow_path s shown;
  draw_all s

let note s (news : Rendering.news) =
  match (news, s.current) with
  | Failed message, _ ->
      s.terminal.tell message;
      s.stage <- In_error message;
      s.save_when_whole <- false;
      draw_all s
  | Began { scene; picture; first_row }, _ ->
      begin_ s { scene; first_row; refinement = Refinement.start picture }
  | Tile (pass, tile), Some { refinement; _ } ->
      Refinement.note refinement pass tile;
      let { Tile.left; top; width; height } = tile in
      let box = Layout.box s.layout { left; top; width; height } in
      s.damage <- Box.union s.damage box
  | Finished seconds, Some shown -> become_whole s shown seconds
  | (Tile _ | Finished _), None -> ()

let show_whole s scene picture ~first_row seconds =
  let refinement = Refinement.complete picture in
  let shown = { Shown.scene; first_row; refinement } in
  begin_ s shown;
  become_whole s shown seconds

let render s =
  s.render_again <- true;
  Option.iter Rendering.stop s.rendering

let pause s =
  let is_rendering = s.rendering <> None || s.render_again in
  if not is_rendering then 0.1
  else if Option.is_none (look s) then 0.01
  else 0.03

let advance s =
  match s.rendering with
  | Some rendering ->
      let over = Rendering.is_over rendering in
      let news = Rendering.news rendering in
      (* what a stopped rendering still has to tell does not matter *)
      if not s.render_again then List.iter (note s) news;
      if over then (
        s.rendering <- None;
        Rendering.join rendering)
  | None when s.render_again ->
      s.render_again <- false;
      let { domains; rows; source; _ } = s in
      s.rendering <- Some (Rendering.start ~domains ?rows source.load)
  | None -> ()

let finish s =
  Option.iter
    (fun rendering ->
      Rendering.stop rendering;
      s.rendering <- None;
      Rendering.join rendering)
    s.rendering

(* {1 Keys, and the whole} *)

let key s : Key.t -> _ = function
  | Close -> `Close
  | command ->
      (match command with
      | Save -> save s
      | Render -> render s
      | Help -> s.terminal.print Key.help
      | Toggle_path ->
          s.path <-
            Option.map (fun p -> { p with visible = not p.visible }) s.path;
          draw_all s
      | Clear ->
          s.path <- None;
          draw_all s
      | Close -> ());
      `Go_on

let step s =
  advance s;
  let { Box.width; height; _ } = Layout.window s.layout in
  if Canvas.size s.canvas <> (width, height) then lay_out_again s;
  draw s
