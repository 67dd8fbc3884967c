open Raylab_tracer
open Raylab_drawing

type t = {
  name : string;
  screen : (int * int) option;
  picture_size : int * int;
  layout : Layout.t;
  raster : Raster.t;
  stage : Stage.t;
  current : Shown.t option;  (** the last that was begun *)
  whole : Shown.t option;  (** the last that became whole *)
  path : Pixel_path.t option;
  save_when_whole : bool;
  is_closed : bool;
  damage : Box.t;  (** what is to be drawn anew *)
}

type event =
  | Pressed of char
  | Clicked of int * int
  | Resized of int * int
  | Changed
  | News of Rendering.news
  | Saving_checked of (unit, string) result
  | Rendered of Shown.t * float

type request =
  | Render
  | Check_saving
  | Save of Picture.t
  | Print of string
  | Tell of string
  | Explain of Explain.pixel
  | Resize of int * int

(* {1 Layout} *)

let raster layout = Raster.make layout ~background:Shown.background

let make ~name ~screen ~window ~picture =
  let layout = Layout.make ~window ~picture in
  {
    name;
    screen;
    picture_size = picture;
    layout;
    raster = raster layout;
    stage = Reading;
    current = None;
    whole = None;
    path = None;
    save_when_whole = false;
    is_closed = false;
    damage = Layout.window layout;
  }

let window_size v =
  let { Box.width; height; _ } = Layout.window v.layout in
  (width, height)

let draw_all v = { v with damage = Layout.window v.layout }

let lay_out v ~window ~picture =
  let layout = Layout.make ~window ~picture in
  let raster = raster layout in
  draw_all { v with picture_size = picture; layout; raster }

let resized v window =
  if window = window_size v then v
  else lay_out v ~window ~picture:v.picture_size

(* {1 Clicks} *)

(* What a click is about, and what is saved. *)
let in_view v =
  match v.stage with In_error _ | Reading -> v.whole | _ -> v.current

let click v place =
  match (in_view v, Layout.pixel v.layout place) with
  | Some shown, Some pixel when Shown.size shown = v.picture_size ->
      let e = Shown.explain shown pixel in
      let path = Pixel_path.make shown pixel e ~is_visible:true in
      (draw_all { v with path = Some path }, [ Explain e ])
  | _ -> (v, [])

(* The pixel that was asked about stays the same when the scene changes. *)
let follow shown { Pixel_path.pixel = (x, y) as pixel; is_visible; _ } =
  let width, height = Shown.size shown in
  if x < width && y < height then
    let e = Shown.explain shown pixel in
    Some (Pixel_path.make shown pixel e ~is_visible)
  else None

(* {1 Rendering} *)

let save v =
  match (v.stage, v.whole) with
  | Took _, Some { refinement; _ } ->
      (v, [ Save (Refinement.picture refinement) ])
  | In_error _, _ ->
      (v, [ Tell "the scene is in error: there is no picture to save" ])
  | _ -> (v, [ Check_saving ])

let saving_checked v = function
  | Error message -> (v, [ Tell message ])
  | Ok () ->
      ( { v with save_when_whole = true },
        [ Tell "the picture will be saved when it is whole" ] )

let begin_ v shown =
  let picture = Shown.size shown in
  let path = Option.bind v.path (follow shown) in
  let v = { v with stage = Rendering; current = Some shown; path } in
  if picture = v.picture_size then (draw_all v, [])
  else
    let width, height = Layout.window_size ~screen:v.screen picture in
    (lay_out v ~window:(window_size v) ~picture, [ Resize (width, height) ])

let become_whole v shown seconds =
  let v = { v with whole = Some shown; stage = Took seconds } in
  if v.save_when_whole then save { v with save_when_whole = false } else (v, [])

let news v (news : Rendering.news) =
  match (news, v.current) with
  | Failed message, _ ->
      let v = { v with stage = In_error message; save_when_whole = false } in
      (draw_all v, [ Tell message ])
  | Began { scene; picture; first_row }, _ ->
      let passes = Render.passes picture scene in
      let refinement = Refinement.start ~passes picture in
      begin_ v { scene; first_row; refinement }
  | Tile (pass, tile), Some { refinement; _ } ->
      Refinement.note refinement pass tile;
      let { Tile.left; top; width; height } = tile in
      let box = Layout.box v.layout { left; top; width; height } in
      ({ v with damage = Box.union v.damage box }, [])
  | Finished seconds, Some shown -> become_whole v shown seconds
  | (Tile _ | Finished _), None -> (v, [])

(* {1 Events} *)

let press v : Key.t -> _ = function
  | Save -> save v
  | Render -> (v, [ Render ])
  | Help -> (v, [ Print Key.help ])
  | Toggle_path ->
      let toggle (p : Pixel_path.t) =
        { p with is_visible = not p.is_visible }
      in
      (draw_all { v with path = Option.map toggle v.path }, [])
  | Clear -> (draw_all { v with path = None }, [])
  | Close -> ({ v with is_closed = true }, [])

let step v = function
  | Pressed c -> Option.fold (Key.of_char c) ~none:(v, []) ~some:(press v)
  | Clicked (x, y) -> click v (x, y)
  | Resized (width, height) -> (resized v (width, height), [])
  | Changed -> (v, [ Render ])
  | News n -> news v n
  | Saving_checked result -> saving_checked v result
  | Rendered (shown, seconds) ->
      let v, first = begin_ v shown in
      let v, second = become_whole v shown seconds in
      (v, first @ second)

let is_closed v = v.is_closed

(* {1 What is to be seen} *)

let look v =
  let is_seen shown =
    Shown.size shown = v.picture_size && Refinement.part shown.refinement > 0.
  in
  let of_first some =
    match List.filter is_seen (List.filter_map Fun.id some) with
    | [] -> None
    | seen -> Some (Shown.look seen)
  in
  match v.stage with
  | In_error _ -> Option.map Raster.dim (of_first [ v.whole ])
  | Reading -> of_first [ v.whole ]
  | Rendering | Took _ -> of_first [ v.current; v.whole ]

let shows_something v = Option.is_some (look v)

let title v =
  let part =
    match v.current with
    | None -> 0.
    | Some { refinement; _ } -> Refinement.part refinement
  in
  Stage.title v.stage ~name:v.name ~size:v.picture_size ~part

type image = { box : Box.t; rows : int array array option; over : Drawing.t }

let draw ~text_size v =
  let box = Box.inter v.damage (Layout.window v.layout) in
  if Box.is_empty box then (v, None)
  else
    let rows look = Raster.rows v.raster look ~top:box.top ~height:box.height
    and over =
      match (v.stage, v.path) with
      | In_error message, _ ->
          let window = Box.rectangle (Layout.window v.layout) in
          Message.draw ~text_size window message
      | _, Some path -> Pixel_path.draw ~text_size v.layout path
      | _, None -> []
    in
    ( { v with damage = Box.empty },
      Some { box; rows = Option.map rows (look v); over } )
