open Raylab_drawing

type t = { pixel : int * int; overlay : Overlay.t; is_visible : bool }

let make shown pixel explanation ~is_visible =
  { pixel; overlay = Shown.overlay shown explanation; is_visible }

let draw ~text_size layout { pixel; overlay; is_visible } =
  if not is_visible then []
  else
    let window = Box.rectangle (Layout.window layout) in
    Overlay.draw ~place:(Layout.place layout) window ~pixel overlay
    @ Legend.in_corner ~text_size window (Overlay.kinds overlay)
