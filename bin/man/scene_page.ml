open Raylab_manual

(* scene_page PAGE VERSION prints raylab-scene(5): PAGE, which is
   doc/language.md, as a page of the manual. *)

(* The day when it is made, or another that packagers ask for. *)
let date () =
  let asked = Option.bind (Sys.getenv_opt "SOURCE_DATE_EPOCH") in
  let seconds =
    Option.value (asked float_of_string_opt) ~default:(Unix.time ())
  in
  let { Unix.tm_year; tm_mon; tm_mday; _ } = Unix.gmtime seconds in
  Printf.sprintf "%d-%02d-%02d" (tm_year + 1900) (tm_mon + 1) tm_mday

(* Without hyphenation, ragged right and one space after a sentence, as the
   other pages are. *)
let head version =
  Printf.sprintf
    {|.TH RAYLAB-SCENE 5 %s "raylab %s" "Raylab Manual"
.nh
.ad l
.ss 12 0
.SH NAME
raylab\-scene \- the scene language of raylab
.SH DESCRIPTION
|}
    (date ()) version

let foot =
  {|.SH FILES
These are in the folder \fBdoc/raylab\fR of what raylab is installed in, such as
\fB\(ti/.local/doc/raylab\fR; \fBraylab \-\-help\fR says where that is.
.TP
.B doc/language.md
This page with its pictures, which are in
.BR doc/language ,
as its scenes are.
.TP
.B scenes
A gallery of scenes, each with comments for its reader.
.TP
.B scenes/why\-black.md
A lesson at the prompt of
.BR raylab\-repl (1).
.SH SEE ALSO
.BR raylab (1),
.BR raylab\-check (1),
.BR raylab\-explain (1),
.BR raylab\-render (1),
.BR raylab\-repl (1),
.BR raylab\-view (1)
|}

let () =
  match Sys.argv with
  | [| _; page; version |] -> (
      let lines = In_channel.with_open_bin page In_channel.input_lines in
      match Markdown.parse lines with
      | Ok blocks ->
          print_string (head version);
          List.iter print_endline (Roff.lines blocks);
          print_string foot
      | Error message ->
          Printf.eprintf "%s, %s\n" page message;
          exit 1)
  | _ ->
      prerr_endline "usage: scene_page PAGE VERSION";
      exit 2
