open Raylab_viewer

type t = {
  canvas : Canvas.t;
  terminal : Terminal.t;
  renderer : Renderer.t;
  render : unit -> Rendering.t;
  look : Raylab_tracer.Prepared.t -> Rendering.t;
  can_save : unit -> (unit, string) result;
  save : Raylab_tracer.Picture.t -> string;
  has_changed : unit -> bool;
}

let rec handle shell viewer event =
  let viewer, requests = Viewer.step viewer event in
  List.fold_left (answer shell) viewer requests

and answer shell viewer (request : Viewer.request) =
  let only () = viewer in
  match request with
  | Render -> only (Renderer.restart shell.renderer shell.render)
  | Look scene ->
      only (Renderer.restart shell.renderer (fun () -> shell.look scene))
  | Check_saving -> handle shell viewer (Saving_checked (shell.can_save ()))
  | Save picture -> handle shell viewer (Saved (shell.save picture))
  | Print text -> only (shell.terminal.print text)
  | Tell text -> only (shell.terminal.tell text)
  | Explain pixel -> only (shell.terminal.explain pixel)
  | Resize (width, height) -> only (Canvas.resize shell.canvas ~width ~height)

(* How long, in seconds, there may be no look at what was rendered: shortest
   while a hand is to be followed, or there is nothing to see yet. *)
let pause { renderer; _ } viewer =
  if Renderer.is_turning renderer then 0.002
  else if Viewer.is_holding viewer then 0.02
  else if not (Renderer.is_busy renderer) then 0.1
  else if Viewer.shows_something viewer then 0.03
  else 0.01

let event_of : Canvas.event -> Viewer.event = function
  | Key c -> Pressed c
  | Down (x, y) -> Button_down (x, y)
  | Up (x, y) -> Button_up (x, y)

(* Where the pointer is matters while a button is held. *)
let waited ({ canvas; _ } as shell) viewer =
  match Canvas.next canvas ~seconds:(pause shell viewer) with
  | Some event -> Some (event_of event)
  | None when Viewer.is_holding viewer ->
      let x, y = Canvas.pointer canvas in
      Some (Pointer_at (x, y))
  | None -> None

let rec loop ({ canvas; renderer; has_changed; _ } as shell) viewer =
  let after = List.fold_left (handle shell) in
  let viewer = after viewer (if has_changed () then [ Changed ] else []) in
  let news = List.map (fun n -> Viewer.News n) (Renderer.news renderer) in
  let viewer = after viewer news in
  let width, height = Canvas.size canvas in
  let viewer = after viewer [ Resized (width, height) ] in
  let viewer = Painter.viewer canvas viewer in
  let viewer = after viewer (Option.to_list (waited shell viewer)) in
  if not (Viewer.is_closed viewer) then loop shell viewer

let serve shell viewer first =
  try loop shell (handle shell viewer first) with Canvas.Gone -> ()
