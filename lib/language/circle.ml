open Raylab_source

type chain = (string * Span.t) list

let rec find identity (chain : chain) =
  match chain with
  | [] -> None
  | (id, _) :: _ when id = identity -> Some []
  | (_, span) :: rest ->
      Option.map (fun spans -> span :: spans) (find identity rest)

let told sources spans =
  let link span =
    let place = Sources.place sources span in
    Printf.sprintf "%s includes %s in line %d"
      (Printable.text (Sources.name sources span.Span.start))
      (Sources.quote sources span)
      place.line
  in
  String.concat ",\n" (List.map link spans)
