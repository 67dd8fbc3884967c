open Raylab_drawing
open Raylab_explanation

type t = {
  pixel : int * int;
  sentence : string;
  overlay : Overlay.t;
  is_visible : bool;
}

let make shown pixel explanation ~is_visible =
  {
    pixel;
    sentence = Summary.of_pixel explanation;
    overlay = Shown.overlay shown explanation;
    is_visible;
  }

(* around the ring of the pixel *)
let clearance = 12.

let draw ~text_size layout
    { pixel = (x, y) as pixel; sentence; overlay; is_visible } =
  if not is_visible then []
  else
    let window = Box.rectangle (Layout.window layout)
    and place = Layout.place layout in
    let middle = place (float_of_int x +. 0.5, float_of_int y +. 0.5) in
    let avoid = Rectangle.around middle clearance in
    let rest, words = Message.note ~text_size ~avoid window sentence in
    Overlay.draw ~place window ~pixel overlay
    @ words
    @ Legend.in_corner ~text_size rest (Overlay.kinds overlay)
