open Raylab_scene

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

(* {1 Looks} *)

(* In the short form of CSS where there is one. *)
let ink i =
  let digits = pf "%06x" i in
  let is_pair k = digits.[2 * k] = digits.[(2 * k) + 1] in
  if i = 0xffffff then "white"
  else if is_pair 0 && is_pair 1 && is_pair 2 then
    pf "#%c%c%c" digits.[0] digits.[2] digits.[4]
  else "#" ^ digits

let color : Drawing.color -> string = function
  | Ink i -> ink i
  | Seen color ->
      let r, g, b = Color.to_bytes color in
      pf "rgb(%d,%d,%d)" r g b

(* A width and an opacity of 1 need not be said. *)
let stroke { Drawing.ink = i; width; dashes } =
  pf {|stroke="%s"|} (ink i)
  ^ (if width = 1. then "" else pf {| stroke-width="%g"|} width)
  ^
  match dashes with
  | None -> ""
  | Some (dash, gap) -> pf {| stroke-dasharray="%g %g"|} dash gap

let look { Drawing.fill; opacity; outline } =
  pf {|fill="%s"|} (color fill)
  ^ (if opacity = 1. then "" else pf {| fill-opacity="%g"|} opacity)
  ^ match outline with None -> "" | Some outline -> " " ^ stroke outline

(* {1 Elements} *)

let box { Rectangle.left; top; right; bottom } style =
  pf {|<rect x="%s" y="%s" width="%s" height="%s" %s/>|} (number left)
    (number top)
    (number (right -. left))
    (number (bottom -. top))
    style

let anchor : Drawing.anchor -> string = function
  | Start -> "start"
  | Middle -> "middle"
  | End -> "end"

let text { Drawing.words; place = x, y; anchor = a; level; size; ink = i } =
  let y =
    match level with Base -> y | Top -> y +. (Drawing.ascent *. size)
  in
  pf
    {|<text x="%s" y="%s" font-size="%g" text-anchor="%s" fill="%s"
 stroke="white" stroke-width="3" paint-order="stroke">%s</text>|}
    (number x) (number y) size (anchor a) (ink i) (escape words)

let mark : Drawing.mark -> string = function
  | Line (pen, (x, y), (x', y')) ->
      pf {|<line x1="%s" y1="%s" x2="%s" y2="%s" %s/>|} (number x) (number y)
        (number x') (number y') (stroke pen)
  | Circle (l, (x, y), radius) ->
      pf {|<circle cx="%s" cy="%s" r="%s" %s/>|} (number x) (number y)
        (number radius) (look l)
  | Polygon (l, corners) ->
      let corner (x, y) = pf "%s,%s" (number x) (number y) in
      pf {|<polygon points="%s" %s/>|}
        (String.concat " " (List.map corner corners))
        (look l)
  | Box (l, rectangle) -> box rectangle (look l)
  | Text t -> text t

(* {1 Files} *)

let part : Sheet.part -> string list = function
  | Free drawing -> List.map mark drawing
  | Panel { name; box = b; paper; drawing } ->
      [
        pf {|<clipPath id="%s">%s</clipPath>|} name (box b "");
        box b (look paper);
        pf {|<g clip-path="url(#%s)">|} name;
      ]
      @ List.map mark drawing @ [ "</g>" ]

let document { Sheet.width; height; title; parts } =
  String.concat "\n"
    (pf
       {|<svg xmlns="http://www.w3.org/2000/svg" width="%g" height="%g"
 viewBox="0 0 %g %g" font-family="sans-serif">|}
       width height width height
    :: pf "<title>%s</title>" (escape title)
    :: {|<rect width="100%" height="100%" fill="white"/>|}
    :: List.concat_map part parts)
  ^ "\n</svg>\n"
