type attached = { path : string; bytes : string }
type file = { path : string; base : int; text : string }

type t = {
  table : Files.t;
  files : file array;
  attached : attached list; (* the last one first *)
}

let none = { table = Files.none; files = [||]; attached = [] }
let byte_order_mark = "\xef\xbb\xbf"

let add ?path ~name text { table; files; attached } =
  let text =
    if String.starts_with ~prefix:byte_order_mark text then
      let n = String.length byte_order_mark in
      String.sub text n (String.length text - n)
    else text
  in
  let path = Option.value path ~default:name
  and name = Printable.text name
  and base = Files.last table + 1 in
  {
    table = Files.add ~name (Lines.index text) table;
    files = Array.append files [| { path; base; text } |];
    attached;
  }

let attach ~path bytes sources =
  { sources with attached = { path; bytes } :: sources.attached }

let make ?path ~name text = add ?path ~name text none
let files sources = Array.to_list sources.files
let attached sources = List.rev sources.attached
let table sources = sources.table

let size { files; attached; _ } =
  let add sum { text; _ } = sum + String.length text
  and attach sum { bytes; _ } = sum + String.length bytes in
  List.fold_left attach (Array.fold_left add 0 files) attached

let paths sources =
  List.map (fun { path; _ } -> path) (files sources)
  @ List.map (fun ({ path; _ } : attached) -> path) (attached sources)

let digest sources =
  let texts = List.map (fun { text; _ } -> text) (files sources)
  and others = List.map (fun { bytes; _ } -> bytes) (attached sources) in
  match List.map Digest.string (texts @ others) with
  | [ digest ] -> digest
  | digests -> Digest.string (String.concat "" digests)

(* {1 Pieces of them} *)

let name sources offset = (Files.find sources.table offset).name

let file sources offset =
  sources.files.((Files.find sources.table offset).index)

let title sources offset =
  match (file sources offset).path with
  | "-" -> name sources offset
  | path -> Printable.text path

(* The line on which a span starts, in its file, without its line end. *)
type line = { file : file; number : int; start : int; stop : int }

let line_of sources (span : Span.t) =
  let { Files.index; line = { number; start; next }; _ } =
    Files.find sources.table span.start
  in
  let file = sources.files.(index) in
  let without c stop =
    if stop > start && file.text.[stop - 1] = c then stop - 1 else stop
  in
  { file; number; start; stop = without '\r' (without '\n' next) }

type place = { line : int; first : int; last : int }

let place sources (span : Span.t) =
  let { file; number; start; stop } = line_of sources span in
  let first = span.start - file.base - start + 1
  and last = Int.min (span.stop - file.base) stop - start in
  { line = number + 1; first; last = Int.max first last }

let slice sources (span : Span.t) =
  let { text; base; _ } = file sources span.start in
  String.sub text (span.start - base) (span.stop - span.start)

let longest_quote = 40

let quote sources (span : Span.t) =
  let { Span.start; stop } = span in
  if stop - start <= longest_quote then Printable.text (slice sources span)
  else
    let stop = start + longest_quote in
    Printable.text (slice sources { start; stop }) ^ "..."

let widest_excerpt = 72

let characters text =
  let count n c = if Char.code c land 0xc0 = 0x80 then n else n + 1 in
  String.fold_left count 0 text

let excerpt sources (span : Span.t) =
  let { file; start; stop; _ } = line_of sources span in
  let span_start = span.start - file.base
  and span_stop = span.stop - file.base in
  let from, until =
    if stop - start <= widest_excerpt then (start, stop)
    else
      let from = Int.max start (span_start - (widest_excerpt / 2)) in
      (from, Int.min stop (from + widest_excerpt))
  in
  let piece a b =
    Printable.text (String.sub file.text a (Int.max 0 (b - a)))
  in
  let cut_before = if from > start then "..." else ""
  and cut_after = if until < stop then "..." else ""
  and marked_stop = Int.min until span_stop in
  let before = cut_before ^ piece from span_start
  and marked = piece span_start marked_stop
  and after = piece marked_stop until ^ cut_after in
  (before ^ marked ^ after, characters before, Int.max 1 (characters marked))
