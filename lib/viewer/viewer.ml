open Raylab_scene
open Raylab_tracer
open Raylab_drawing

type t = {
  name : string;
  screen : (int * int) option;
  picture_size : int * int;
  layout : Layout.t;
  raster : Raster.t;
  exhibit : Exhibit.t;
  steering : Steering.t;
  hand : Hand.t;
  grip : Viewpoint.t option;  (** where the eye was as the hand pressed *)
  path : Pixel_path.t option;
  note : string option;
  save_when_whole : bool;
  is_closed : bool;
  damage : Box.t;  (** what is to be drawn anew *)
}

type event =
  | Pressed of char
  | Button_down of int * int
  | Pointer_at of int * int
  | Button_up of int * int
  | Resized of int * int
  | Changed
  | News of Rendering.news
  | Saving_checked of (unit, string) result
  | Saved of string
  | Rendered of Shown.t * float

type request =
  | Render
  | Look of Prepared.t
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
    exhibit = Exhibit.start;
    steering = Steering.start;
    hand = Hand.free;
    grip = None;
    path = None;
    note = None;
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

(* {1 Messages} *)

let with_note note v = if v.note = note then v else draw_all { v with note }
let tell text v = (with_note (Some text) v, [ Tell text ])
let print text v = (with_note (Some text) v, [ Print text ])

(* {1 Clicks} *)

let without_path v =
  if Option.is_none v.path then v else draw_all { v with path = None }

let click v place =
  match (Exhibit.subject v.exhibit, Layout.pixel v.layout place) with
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

(* {1 The eye} *)

let render v = ({ v with steering = Steering.ask v.steering }, [ Render ])

let is_in_error v =
  match Exhibit.stage v.exhibit with In_error _ -> true | _ -> false

(* The picture from where the eye is, if it is time to begin it. *)
let look_from_there v =
  let is_covered = not (Exhibit.is_hidden v.exhibit) in
  match (Exhibit.current v.exhibit, Steering.next ~is_covered v.steering) with
  | Some { scene; _ }, (steering, Some camera) ->
      ({ v with steering }, [ Look (Prepared.with_camera camera scene) ])
  | _, (steering, _) -> ({ v with steering }, [])

let steer change v =
  if is_in_error v then (v, [])
  else
    let v = { v with steering = change v.steering } in
    look_from_there (without_path v)

(* Moves the eye from where it is. *)
let move change v =
  match Steering.viewpoint v.steering with
  | None -> (v, [])
  | Some viewpoint -> steer (Steering.move (change viewpoint)) v

let drag v ~across ~down =
  match v.grip with
  | None -> (v, [])
  | Some grip ->
      let { Box.width; height; _ } = Layout.shown v.layout in
      let part length shown = float_of_int length /. float_of_int shown in
      let across = part across width and down = part down height in
      steer (Steering.move (Orbit.turn ~across ~down grip)) v

let gesture v : Hand.gesture -> _ = function
  | Nothing -> (v, [])
  | Click place -> click v place
  | Drag { across; down } -> drag v ~across ~down

let button_down v place =
  let grip = Steering.viewpoint v.steering in
  (with_note None { v with hand = Hand.press place; grip }, [])

let pointer_at v place =
  let hand, found = Hand.move place v.hand in
  gesture { v with hand } found

let button_up v place =
  gesture { v with hand = Hand.free } (Hand.release place v.hand)

let print_view v =
  match Steering.viewpoint v.steering with
  | None -> (v, [])
  | Some viewpoint -> print (Orbit.settings viewpoint) v

(* {1 Rendering} *)

let save v =
  match (Exhibit.stage v.exhibit, Exhibit.whole v.exhibit) with
  | Took _, Some { refinement; _ } when not (Steering.is_under_way v.steering)
    ->
      (v, [ Save (Refinement.picture refinement) ])
  | In_error _, _ ->
      tell "the scene is in error: there is no picture to save" v
  | _ -> (v, [ Check_saving ])

let saving_checked v = function
  | Error message -> tell message v
  | Ok () ->
      tell "the picture will be saved when it is whole"
        { v with save_when_whole = true }

(* Of a picture of the scene itself, and of one from where the eye was put. *)
let begin_ v shown =
  let picture = Shown.size shown in
  let at_once = Steering.is_view v.steering in
  let exhibit = Exhibit.begin_ ~at_once shown v.exhibit
  and steering = Steering.begin_ shown.scene.scene.camera v.steering
  and path = Option.bind v.path (follow shown) in
  let v = { v with exhibit; steering; path } in
  let v, first =
    if picture = v.picture_size then ((if at_once then v else draw_all v), [])
    else
      let width, height = Layout.window_size ~screen:v.screen picture in
      (lay_out v ~window:(window_size v) ~picture, [ Resize (width, height) ])
  in
  let v, second = look_from_there v in
  (v, first @ second)

let become_whole v seconds =
  let v = { v with exhibit = Exhibit.finish seconds v.exhibit } in
  if v.save_when_whole then save { v with save_when_whole = false } else (v, [])

let fail v message =
  let exhibit = Exhibit.fail message v.exhibit
  and steering = Steering.fail v.steering in
  let v = { v with exhibit; steering; save_when_whole = false; note = None } in
  (draw_all v, [ Tell message ])

let tile v pass { Tile.left; top; width; height } =
  match Exhibit.note pass { Tile.left; top; width; height } v.exhibit with
  | `Nothing -> (v, [])
  | `All -> look_from_there (draw_all v)
  | `Tile ->
      let box = Layout.box v.layout { left; top; width; height } in
      ({ v with damage = Box.union v.damage box }, [])

let news v (news : Rendering.news) =
  match (news, Exhibit.current v.exhibit) with
  | Failed message, _ -> fail v message
  | Began { scene; picture; first_row }, _ ->
      let passes = Render.passes picture scene in
      begin_ v
        { scene; first_row; refinement = Refinement.start ~passes picture }
  | Tile (pass, part), Some _ -> tile v pass part
  | Finished seconds, Some _ -> become_whole v seconds
  | (Tile _ | Finished _), None -> (v, [])

(* {1 Events} *)

let step_of_zoom = 1.25

let press v : Key.t -> _ = function
  | Save -> save v
  | Render -> render v
  | Help -> print Key.help v
  | Toggle_path ->
      let toggle (p : Pixel_path.t) =
        { p with is_visible = not p.is_visible }
      in
      (draw_all { v with path = Option.map toggle v.path }, [])
  | Clear -> (without_path v, [])
  | Nearer -> move (Orbit.nearer step_of_zoom) v
  | Farther -> move (Orbit.nearer (1. /. step_of_zoom)) v
  | Back -> steer Steering.back v
  | Print_view -> print_view v
  | Close -> ({ v with is_closed = true }, [])

let step v = function
  | Pressed c ->
      let v = with_note None v in
      Option.fold (Key.of_char c) ~none:(v, []) ~some:(press v)
  | Button_down (x, y) -> button_down v (x, y)
  | Pointer_at (x, y) -> pointer_at v (x, y)
  | Button_up (x, y) -> button_up v (x, y)
  | Resized (width, height) -> (resized v (width, height), [])
  | Changed -> render (with_note None v)
  | News n -> news v n
  | Saving_checked result -> saving_checked v result
  | Saved text -> tell text v
  | Rendered (shown, seconds) ->
      let v, first = begin_ v shown in
      let v, second = become_whole v seconds in
      (v, first @ second)

let is_holding v = not (Hand.is_free v.hand)
let is_closed v = v.is_closed

(* {1 What is to be seen} *)

let look v = Exhibit.look ~size:v.picture_size v.exhibit
let shows_something v = Option.is_some (look v)

let title v =
  let part =
    match Exhibit.current v.exhibit with
    | None -> 0.
    | Some { refinement; _ } -> Refinement.part refinement
  in
  Stage.title (Exhibit.stage v.exhibit) ~name:v.name ~size:v.picture_size ~part

(* Over the picture: what is wrong, or the path of a pixel; and a message. *)
let over ~text_size v =
  let window = Box.rectangle (Layout.window v.layout) in
  let below =
    match (Exhibit.stage v.exhibit, v.path, v.note) with
    | In_error message, _, _ -> Message.draw ~text_size window message
    | _, Some path, None -> Pixel_path.draw ~text_size v.layout path
    | _ -> []
  and note =
    Option.fold ~none:[] v.note ~some:(fun text ->
        snd (Message.note ~text_size window text))
  in
  below @ note

type image = { box : Box.t; rows : int array array option; over : Drawing.t }

let draw ~text_size v =
  let box = Box.inter v.damage (Layout.window v.layout) in
  if Box.is_empty box then (v, None)
  else
    let rows look =
      Raster.rows v.raster look ~top:box.top ~height:box.height
    in
    ( { v with damage = Box.empty },
      Some { box; rows = Option.map rows (look v); over = over ~text_size v }
    )
