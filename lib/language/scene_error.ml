open Raylab_source

type t = {
  file : string;
  place : Sources.place option;
  message : string;
  excerpt : string;
  advice : string;
}

let draw_excerpt sources span (place : Sources.place) =
  let line, before, length = Sources.excerpt sources span in
  let number = Printf.sprintf "%5d" place.line in
  let margin = String.make (String.length number) ' ' in
  Printf.sprintf "%s | %s\n%s | %s%s" number line margin
    (String.make before ' ') (String.make length '^')

let make sources (span : Span.t) ?(advice = "") message =
  let place = Sources.place sources span in
  {
    file = Sources.title sources span.start;
    place = Some place;
    message;
    excerpt = draw_excerpt sources span place;
    advice;
  }

let whole sources { Sources.base; _ } ?advice message =
  let error = make sources { start = base; stop = base } ?advice message in
  { error with excerpt = "" }

let unreadable ~file reason =
  {
    file = Printable.text file;
    place = None;
    message = Printable.text reason;
    excerpt = "";
    advice = "";
  }

let pp_place ppf = function
  | None -> ()
  | Some { Sources.line; first; last } when first = last ->
      Format.fprintf ppf ":%d:%d" line first
  | Some { line; first; last } ->
      Format.fprintf ppf ":%d:%d-%d" line first last

let pp_lines ppf text =
  if text <> "" then
    List.iter
      (fun line ->
        Format.pp_force_newline ppf ();
        Format.pp_print_string ppf line)
      (String.split_on_char '\n' text)

let pp ppf { file; place; message; excerpt; advice } =
  Format.fprintf ppf "@[<v>%s%a: error: %s%a%a@]" file pp_place place message
    pp_lines excerpt pp_lines advice
