open Raylab_source

type t = {
  file : string;
  place : Source.place option;
  message : string;
  excerpt : string;
  advice : string;
}

let draw_excerpt source span (place : Source.place) =
  let line, before, length = Source.excerpt source span in
  let number = Printf.sprintf "%5d" place.line in
  let margin = String.make (String.length number) ' ' in
  Printf.sprintf "%s | %s\n%s | %s%s" number line margin
    (String.make before ' ') (String.make length '^')

let make source span ?(advice = "") message =
  let place = Source.place source span in
  {
    file = Source.name source;
    place = Some place;
    message;
    excerpt = draw_excerpt source span place;
    advice;
  }

let whole source ?(advice = "") message =
  let place = Source.place source (Span.make ~start:0 ~stop:0) in
  {
    file = Source.name source;
    place = Some place;
    message;
    excerpt = "";
    advice;
  }

let unreadable ~file reason =
  {
    file = Source.printable file;
    place = None;
    message = Source.printable reason;
    excerpt = "";
    advice = "";
  }

let pp_place ppf = function
  | None -> ()
  | Some { Source.line; first; last } when first = last ->
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
