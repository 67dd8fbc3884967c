open Raylab_scene
open Raylab_drawing
open Raylab_viewer

let nearest x = int_of_float (Float.round x)

let color : Drawing.color -> int = function
  | Ink ink -> ink
  | Seen color ->
      let r, g, b = Color.to_bytes color in
      (r lsl 16) lor (g lsl 8) lor b

let line canvas { Drawing.ink; width; dashes } ends =
  let parts =
    match dashes with None -> [ ends ] | Some d -> Dashes.cut d ends
  in
  List.iter (Canvas.line canvas ~color:ink ~width:(nearest width)) parts

let outline canvas (look : Drawing.look) corners =
  match (look.outline, corners) with
  | Some pen, first :: others ->
      List.iter2
        (fun a b -> line canvas pen (a, b))
        corners (others @ [ first ])
  | _ -> ()

(* Graphics mixes no colours: what is not opaque has only its outline. *)
let fill (look : Drawing.look) paint =
  if look.opacity = 1. then paint (color look.fill)

(* A circle by its corners, which are too many to be seen. *)
let around centre radius =
  let count = 48 in
  List.init count (fun k ->
      let angle = 2. *. Float.pi *. float_of_int k /. float_of_int count in
      Way.from centre (cos angle, sin angle) radius 0.)

let box_of { Rectangle.left; top; right; bottom } =
  let left = nearest left and top = nearest top in
  {
    Box.left;
    top;
    width = nearest right - left;
    height = nearest bottom - top;
  }

(* Graphics does not tell where in a line of words the base line is. *)
let text canvas { Drawing.words; place = x, y; anchor; level; ink; _ } =
  let words = Ascii.of_utf_8 words in
  let width, height = Canvas.text_size canvas words in
  let part = match anchor with Start -> 0. | Middle -> 0.5 | End -> 1.
  and above = match level with Top -> 0. | Base -> Drawing.ascent in
  Canvas.text canvas ~color:ink
    ~left:(nearest (x -. (part *. float_of_int width)))
    ~top:(nearest (y -. (above *. float_of_int height)))
    words

let mark canvas : Drawing.mark -> unit = function
  | Line (pen, a, b) -> line canvas pen (a, b)
  | Circle (look, centre, radius) ->
      fill look (fun color ->
          Canvas.disc canvas ~color ~radius:(nearest radius) centre);
      outline canvas look (around centre radius)
  | Polygon (look, corners) ->
      fill look (fun color -> Canvas.polygon canvas ~color corners);
      outline canvas look corners
  | Box (look, ({ left; top; right; bottom } as box)) ->
      fill look (fun color -> Canvas.fill canvas ~color (box_of box));
      outline canvas look
        [ (left, top); (right, top); (right, bottom); (left, bottom) ]
  | Text t -> text canvas t

let drawing canvas = List.iter (mark canvas)

(* {1 The viewer} *)

let text_size canvas words =
  let width, height = Canvas.text_size canvas (Ascii.of_utf_8 words) in
  (float_of_int width, float_of_int height)

let image canvas { Viewer.box; rows; over } =
  (match rows with
  | None -> Canvas.fill canvas ~color:Shown.background box
  | Some rows -> Canvas.paint canvas ~left:0 ~top:box.top rows);
  drawing canvas over;
  Canvas.show canvas

let viewer canvas v =
  Canvas.set_title canvas (Viewer.title v);
  let v, changed = Viewer.draw ~text_size:(text_size canvas) v in
  Option.iter (image canvas) changed;
  v
