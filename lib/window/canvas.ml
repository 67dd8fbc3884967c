open Raylab_viewer
module G = Graphics

exception Gone

(* Graphics frees an image when the garbage collector finds it, and crashes if
   the window is no longer there. So images are held here until it is a good
   time to free them, and for ever if the window is gone. This is about the one
   window that Graphics has in a process, and so it is a global state. *)
let images = ref []
let pixels_in_images = ref 0
let most_pixels_in_images = 8_000_000

let free_images () =
  if !images <> [] then (
    images := [];
    pixels_in_images := 0;
    Gc.full_major ())

let window_was_lost = ref false

type t = {
  mutable is_open : bool;
  mutable title : string;
  on_loss : unit -> unit;
}

let guard canvas f =
  if not canvas.is_open then raise Gone;
  try f ()
  with G.Graphic_failure _ ->
    canvas.is_open <- false;
    window_was_lost := true;
    canvas.on_loss ();
    raise Gone

let reason message =
  if String.starts_with ~prefix:"Cannot open display" message then
    match Sys.getenv_opt "DISPLAY" with
    | None | Some "" -> "no display was found: DISPLAY is not set"
    | Some display ->
        Printf.sprintf "no display was found: cannot open '%s'"
          (Ascii.of_utf_8 display)
  else message

let open_ ~on_loss ~title ~width ~height =
  if !window_was_lost then
    Error "the display was lost, and cannot be opened again by this process"
  else
    let title = Ascii.of_utf_8 title in
    try
      G.set_window_title title;
      G.open_graph (Printf.sprintf " %dx%d" width height);
      (* Graphics wants to handle events whenever one comes, or, depending on
         how it was built, four times a second: on whichever domain gets the
         signal, and in the middle of anything. They can wait until [next]
         asks. *)
      Sys.set_signal Sys.sigpoll Signal_ignore;
      Tick.quiet ();
      G.auto_synchronize false;
      Ok { is_open = true; title; on_loss }
    with G.Graphic_failure message -> Error (reason message)

let close canvas =
  if canvas.is_open then (
    canvas.is_open <- false;
    free_images ();
    G.close_graph ())

(* Waits for an answer of the server, and fails if there is no window or no
   server. A server that goes away fails but one call, and that failure may get
   lost: where a tick comes at the same moment, the runtime raises that instead.
   Afterwards the pointer is said to be at (-1, -1), where it may really be, and
   there is no font, which every server has. *)
let ask_the_server () =
  let { G.mouse_x; mouse_y; _ } = G.wait_next_event [ Poll ] in
  if mouse_x = -1 && mouse_y = -1 then G.set_font "fixed"

let size canvas = guard canvas (fun () -> (G.size_x (), G.size_y ()))

let resize canvas ~width ~height =
  guard canvas (fun () -> G.resize_window width height)

let set_title canvas title =
  let title = Ascii.of_utf_8 title in
  if title <> canvas.title then
    guard canvas (fun () ->
        canvas.title <- title;
        G.set_window_title title)

(* {1 Drawing} *)

let paint canvas ~left ~top colors =
  let height = Array.length colors in
  if height > 0 && colors.(0) <> [||] then
    guard canvas (fun () ->
        if !pixels_in_images > most_pixels_in_images then free_images ();
        (* If the display is away this notices, and not the call below, which
           would leave an image behind that nobody holds. *)
        ask_the_server ();
        let image = G.make_image colors in
        images := image :: !images;
        pixels_in_images :=
          !pixels_in_images + (height * Array.length colors.(0));
        G.draw_image image left (G.size_y () - top - height))

(* Graphics counts rows from the bottom. *)
let flip y = G.size_y () - 1 - y

let nearest (x, y) =
  (int_of_float (Float.round x), int_of_float (Float.round y))

let line canvas ~color ~width (a, b) =
  guard canvas (fun () ->
      let x, y = nearest a and x', y' = nearest b in
      G.set_color color;
      G.set_line_width width;
      G.moveto x (flip y);
      G.lineto x' (flip y'))

let disc canvas ~color ~radius centre =
  guard canvas (fun () ->
      let x, y = nearest centre in
      G.set_color color;
      G.fill_circle x (flip y) radius)

let polygon canvas ~color corners =
  guard canvas (fun () ->
      let corner p =
        let x, y = nearest p in
        (x, flip y)
      in
      G.set_color color;
      G.fill_poly (Array.of_list (List.map corner corners)))

let fill canvas ~color { Box.left; top; width; height } =
  guard canvas (fun () ->
      G.set_color color;
      G.fill_rect left (G.size_y () - top - height) width height)

let text_size canvas line = guard canvas (fun () -> G.text_size line)

let text canvas ~color ~left ~top line =
  guard canvas (fun () ->
      let _, height = G.text_size line in
      G.set_color color;
      G.moveto left (G.size_y () - top - height);
      G.draw_string line)

let show canvas = guard canvas G.synchronize

(* {1 Events} *)

type event = Key of char | Down of int * int | Up of int * int

let wanted = [ G.Button_down; G.Button_up; G.Key_pressed ]

let next canvas ~seconds =
  guard canvas (fun () ->
      match Tick.within ~seconds (fun () -> G.wait_next_event wanted) with
      | Some { keypressed = true; key; _ } -> Some (Key key)
      | Some { mouse_x; mouse_y; button = true; _ } ->
          Some (Down (mouse_x, flip mouse_y))
      | Some { mouse_x; mouse_y; _ } -> Some (Up (mouse_x, flip mouse_y))
      | None ->
          ask_the_server ();
          None)

let pointer canvas =
  guard canvas (fun () ->
      let x, y = G.mouse_pos () in
      (x, flip y))
