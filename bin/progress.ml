type t = { mutable shown : bool; started : float; mutable drawn : float }

let start ~quiet =
  let now = Unix.gettimeofday () in
  let shown = (not quiet) && Unix.isatty Unix.stderr in
  { shown; started = now; drawn = now }

(* Often enough to be seen moving, too seldom to cost anything. *)
let seconds_between_drawings = 0.1

let time seconds =
  let s = int_of_float (Float.ceil (Float.min seconds 3.6e6)) in
  if s < 60 then Printf.sprintf "%d s" s
  else if s < 3600 then Printf.sprintf "%d min %02d s" (s / 60) (s mod 60)
  else Printf.sprintf "%d h %02d min" (s / 3600) (s / 60 mod 60)

let clear_line = "\r\027[K"

let draw line text =
  try Printf.eprintf "%s%s%!" clear_line text
  with Sys_error _ -> line.shown <- false

let update line part =
  let now = Unix.gettimeofday () in
  if line.shown && now -. line.drawn >= seconds_between_drawings then (
    line.drawn <- now;
    let left = (now -. line.started) *. ((1. /. Float.max 1e-6 part) -. 1.) in
    draw line
      (Printf.sprintf "rendering %3.0f %%, %s left" (100. *. part) (time left)))

let clear line = if line.shown then draw line ""
