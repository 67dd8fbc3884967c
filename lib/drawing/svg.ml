type t = string
type point = float * float

let pf = Printf.sprintf

(* What lies far outside is shown nowhere; a NaN must not spoil the file. *)
let number x =
  let furthest = 1e5 in
  if Float.is_nan x then "0"
  else pf "%.1f" (Float.max (-.furthest) (Float.min furthest x))

(* XML has no way to write control characters and bytes that are not UTF-8. *)
let is_character code =
  (code >= 0x20 && code < 0x7f)
  || (code >= 0xa0 && code <> 0xfffe && code <> 0xffff)
  || code = 0x09 || code = 0x0a

let escape text =
  let buffer = Buffer.create (String.length text) in
  let rec copy i =
    if i < String.length text then (
      let decoded = String.get_utf_8_uchar text i in
      let char = Uchar.utf_decode_uchar decoded in
      (match Uchar.to_int char with
      | 0x26 -> Buffer.add_string buffer "&amp;"
      | 0x3c -> Buffer.add_string buffer "&lt;"
      | 0x3e -> Buffer.add_string buffer "&gt;"
      | 0x22 -> Buffer.add_string buffer "&quot;"
      | code ->
          Buffer.add_utf_8_uchar buffer
            (if is_character code then char else Uchar.rep));
      copy (i + Uchar.utf_decode_length decoded))
  in
  copy 0;
  Buffer.contents buffer

let document ~width ~height ~title elements =
  String.concat "\n"
    (pf
       {|<svg xmlns="http://www.w3.org/2000/svg" width="%g" height="%g"
 viewBox="0 0 %g %g" font-family="sans-serif">|}
       width height width height
    :: pf "<title>%s</title>" (escape title)
    :: {|<rect width="100%" height="100%" fill="white"/>|} :: elements)
  ^ "\n</svg>\n"

let group ?clip elements =
  let clip =
    match clip with
    | None -> ""
    | Some name -> pf {| clip-path="url(#%s)"|} name
  in
  pf "<g%s>\n%s\n</g>" clip (String.concat "\n" elements)

let box ~style (x, y) ~width ~height =
  pf {|<rect x="%s" y="%s" width="%s" height="%s" %s/>|} (number x) (number y)
    (number width) (number height) style

let clip_box ~name corner ~width ~height =
  pf {|<clipPath id="%s">%s</clipPath>|} name
    (box ~style:"" corner ~width ~height)

let circle ~style (x, y) radius =
  pf {|<circle cx="%s" cy="%s" r="%s" %s/>|} (number x) (number y)
    (number radius) style

let line ~style (x, y) (x', y') =
  pf {|<line x1="%s" y1="%s" x2="%s" y2="%s" %s/>|} (number x) (number y)
    (number x') (number y') style

let polygon ~style corners =
  let corner (x, y) = pf "%s,%s" (number x) (number y) in
  pf {|<polygon points="%s" %s/>|}
    (String.concat " " (List.map corner corners))
    style

let text ?(anchor = "start") ?(size = 12.) ?(color = "#222") (x, y) words =
  pf
    {|<text x="%s" y="%s" font-size="%g" text-anchor="%s" fill="%s"
 stroke="white" stroke-width="3" paint-order="stroke">%s</text>|}
    (number x) (number y) size anchor color (escape words)
