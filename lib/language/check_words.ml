open Raylab_geometry
open Raylab_scene

type t = { findings : Findings.t; mutable offset : int }

let start findings offset = { findings; offset }
let source words = Findings.source words.findings
let peek words = Source.next_word (source words) words.offset

let next words =
  let span = peek words in
  words.offset <- Span.stop span;
  span

let skip_keyword words = ignore (next words : Span.t)

let refuse words ?advice message =
  Findings.error words.findings (next words) ?advice message

let number words rule name value =
  Findings.check_value words.findings rule name (next words) value

let part words rule name part value =
  number words rule (Printf.sprintf "the %s of %s" part name) value

let vector words name { Vec3.x; y; z } =
  part words Finite name "x" x;
  part words Finite name "y" y;
  part words Finite name "z" z

let direction words name v =
  let start = Span.start (peek words) in
  vector words name v;
  if Vec3.equal v Vec3.zero then
    Findings.error words.findings
      (Span.make ~start ~stop:words.offset)
      (name ^ " must not be the zero vector")
      ~advice:"give at least one number that is not 0, such as 0 1 0"

let color words name { Color.r; g; b } =
  match Keyword.token (Source.slice (source words) (peek words)) with
  | Some (COLOR _) -> skip_keyword words
  | _ ->
      part words Non_negative name "red" r;
      part words Non_negative name "green" g;
      part words Non_negative name "blue" b
