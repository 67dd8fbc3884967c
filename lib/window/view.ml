open Raylab_parallel
open Raylab_scene
open Raylab_tracer
open Raylab_viewer

type source = {
  name : string;
  load : unit -> (Scene.t, string) result;
  can_save : unit -> (unit, string) result;
  save : Picture.t -> string;
}

type first =
  | Scene of Scene.t
  | Error of string
  | Rendered of { scene : Prepared.t; picture : Picture.t; seconds : float }

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

let first_event rows = function
  | Scene _ | Error _ -> Viewer.Changed
  | Rendered { scene; picture; seconds } ->
      let first_row =
        match rows with None -> 0 | Some { Render.first; _ } -> first
      in
      let refinement = Refinement.complete picture in
      Viewer.Rendered ({ scene; refinement; first_row }, seconds)

(* The first time [load] need not read what is known already. *)
let once_known first load =
  let known = Atomic.make first in
  fun () ->
    match Atomic.exchange known None with
    | Some result -> result
    | None -> load ()

let seconds_between_looks = 0.1

(* [every seconds f] is [f] asked at most once in [seconds], and else
   [false]. *)
let every seconds f =
  let last = ref neg_infinity in
  fun () ->
    let now = Unix.gettimeofday () in
    Float.abs (now -. !last) >= seconds
    &&
    (last := now;
     f ())

let shell ~domains ?rows ?watch ~terminal { load; can_save; save; _ } first
    canvas =
  let known =
    match first with
    | Scene scene -> Some (Ok scene)
    | Error message -> Some (Error message)
    | Rendered _ -> None
  in
  let load = once_known known load in
  let start =
    Rendering.start ~domains ?rows ~clock:Unix.gettimeofday
      ~enter:Tick.not_here
  in
  let prepared () = Result.map (Prepared.make ~domains) (load ())
  and has_changed () = Option.fold watch ~none:false ~some:Watch.has_changed in
  {
    Shell.canvas;
    terminal;
    renderer = Renderer.make ();
    render = (fun () -> start prepared);
    look = (fun scene -> start (fun () -> Ok scene));
    can_save;
    save;
    has_changed = every seconds_between_looks has_changed;
  }

let run ?(domains = Parallel.default_domains ()) ?rows ?watch
    ?(on_loss = ignore) ~terminal ({ name; _ } as source) first =
  let screen = Screen.size () in
  let picture = picture_size rows first in
  let ((width, height) as window) = Layout.window_size ~screen picture in
  match Canvas.open_ ~on_loss ~title:name ~width ~height with
  | Error _ as error -> error
  | Ok canvas ->
      let shell = shell ~domains ?rows ?watch ~terminal source first canvas in
      Fun.protect
        ~finally:(fun () ->
          Canvas.close canvas;
          Renderer.finish shell.renderer)
        (fun () ->
          Shell.serve shell
            (Viewer.make ~name ~screen ~window ~picture)
            (first_event rows first));
      Ok ()
