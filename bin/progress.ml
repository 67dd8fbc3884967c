type t = {
  mutable shown : bool;
  started : float;
  mutable drawn : float;
  mutable width : int;  (** of what stands there *)
}

let start ~quiet =
  let now = Unix.gettimeofday () in
  let shown = (not quiet) && Unix.isatty Unix.stderr in
  { shown; started = now; drawn = now; width = 0 }

(* Often enough to be seen moving, too seldom to cost anything. *)
let seconds_between_drawings = 0.1

let time seconds =
  let s = int_of_float (Float.ceil (Float.min seconds 3.6e6)) in
  if s < 60 then Printf.sprintf "%d s" s
  else if s < 3600 then Printf.sprintf "%d min %02d s" (s / 60) (s mod 60)
  else Printf.sprintf "%d h %02d min" (s / 3600) (s / 60 mod 60)

(* Blanks take away what was there, on every terminal. *)
let draw line text =
  try
    Printf.eprintf "\r%-*s%!" line.width text;
    line.width <- String.length text
  with Sys_error _ -> line.shown <- false

let update line part =
  let now = Unix.gettimeofday () in
  if line.shown && now -. line.drawn >= seconds_between_drawings then (
    line.drawn <- now;
    let left = (now -. line.started) *. ((1. /. Float.max 1e-6 part) -. 1.) in
    draw line
      (Printf.sprintf "rendering %3.0f %%, %s left" (100. *. part) (time left)))

let is_there line = line.shown && line.width > 0

let clear line =
  if is_there line then (
    draw line "";
    (* to the left again *)
    draw line "")

(* Neither the channel, which another domain may be writing to, nor a terminal
   that is stopped may keep the program from ending. *)
let leave line =
  if is_there line then (
    line.shown <- false;
    try
      if Unix.select [] [ Unix.stderr ] [] 0. <> ([], [], []) then
        ignore (Unix.single_write_substring Unix.stderr "\n" 0 1 : int)
    with Unix.Unix_error _ -> ())
