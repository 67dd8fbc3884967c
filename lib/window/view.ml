open Raylab_parallel
open Raylab_scene
open Raylab_tracer

type first =
  | Scene of Scene.t
  | Error of string
  | Rendered of { scene : Trace.t; picture : Picture.t; seconds : float }

(* of a window that has no picture yet *)
let default_size = (640, 480)

let picture_size rows = function
  | Error _ -> default_size
  | Rendered { picture; _ } -> (Picture.width picture, Picture.height picture)
  | Scene { camera = { width; height; _ }; _ } ->
      let height =
        match rows with
        | Some { Render.first; last } when last < height -> last - first + 1
        | _ -> height
      in
      (width, height)

let begin_with session rows = function
  | Scene _ | Error _ -> Session.render session
  | Rendered { scene; picture; seconds } ->
      let first_row =
        match rows with None -> 0 | Some { Render.first; _ } -> first
      in
      Session.show_whole session scene picture ~first_row seconds

(* The first time [load] need not read what is known already. *)
let once_known first load =
  let known = Atomic.make first in
  fun () ->
    match Atomic.exchange known None with
    | Some result -> result
    | None -> load ()

let seconds_between_looks = 0.1

(* [every seconds f] is a function that is [f] at most once in [seconds], and
   else does nothing. *)
let every seconds f =
  let last = ref neg_infinity in
  fun () ->
    let now = Unix.gettimeofday () in
    if Float.abs (now -. !last) >= seconds then (
      last := now;
      f ())

let serve session canvas watch ~begin_ =
  let look =
    every seconds_between_looks (fun () ->
        match watch with
        | Some watch when Watch.has_changed watch -> Session.render session
        | _ -> ())
  in
  let rec loop () =
    look ();
    Session.step session;
    match Canvas.next canvas ~seconds:(Session.pause session) with
    | None -> loop ()
    | Some (Click (x, y)) ->
        Session.click session (x, y);
        loop ()
    | Some (Key c) -> (
        match Option.map (Session.key session) (Key.of_char c) with
        | Some `Close -> ()
        | Some `Go_on | None -> loop ())
  in
  try
    begin_ ();
    loop ()
  with Canvas.Gone -> ()

let run ?(domains = Parallel.default_domains ()) ?rows ?watch
    ?(on_loss = ignore) ~terminal (source : Session.source) first =
  let screen = Screen.size () in
  let picture = picture_size rows first in
  let width, height = Layout.window_size ~screen picture in
  match
    Canvas.open_ ~on_loss ~title:(Ascii.of_utf_8 source.name) ~width ~height
  with
  | Error _ as error -> error
  | Ok canvas ->
      let known =
        match first with
        | Scene scene -> Some (Ok scene)
        | Error message -> Some (Error message)
        | Rendered _ -> None
      in
      let source = { source with load = once_known known source.load } in
      let session =
        Session.make ~domains ?rows ~terminal ~screen ~picture source canvas
      in
      Fun.protect
        ~finally:(fun () ->
          Canvas.close canvas;
          Session.finish session)
        (fun () ->
          serve session canvas watch ~begin_:(fun () ->
              begin_with session rows first));
      Ok ()
