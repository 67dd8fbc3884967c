open Raylab_geometry
open Raylab_scene

let most = 20
let inset = 24.
let ink = 0xb26a00

let look =
  Drawing.filled ~outline:(Drawing.stroke ~width:1.5 ink) (Ink 0xffd54f)

let label (x, y) words =
  Sketch.label (Label.make ~anchor:Middle ~ink [ (x, y +. 4.) ] words)

let label_above (x, y) words = label (x, y -. 18.) words

let sun centre =
  let ray k =
    let angle = float_of_int k *. Float.pi /. 4. in
    let at r = Way.from centre (cos angle, sin angle) r 0. in
    Drawing.Line (Drawing.stroke ~width:1.5 ink, at 6.5, at 10.)
  in
  Sketch.busy
    (Rectangle.around centre 10.)
    (Circle (look, centre, 5.) :: List.init 8 ray)

(* [towards_edge panel d] is the place near the edge of the panel in direction
   [d], in pixels, from its middle. *)
let towards_edge (panel : Panel.t) (dx, dy) =
  let x, y = Panel.middle panel in
  let reach size d =
    if d = 0. then infinity else ((size /. 2.) -. inset) /. abs_float d
  in
  let t = Float.min (reach panel.width dx) (reach panel.height dy) in
  (x +. (t *. dx), y +. (t *. dy))

let point_light panel name position =
  let ((x, y) as place) = Panel.point panel position in
  if Panel.shows panel place then
    Sketch.all [ sun place; label_above place name ]
  else
    let mx, my = Panel.middle panel in
    let edge = towards_edge panel (x -. mx, y -. my) in
    Sketch.all [ sun edge; label_above edge (name ^ ", farther away") ]

let area panel name pane =
  let middle = Light_outline.middle pane in
  let place = Panel.point panel middle in
  if Panel.shows panel place then
    Sketch.all
      [
        Sketch.busy
          (Rectangle.around place 10.)
          (Light_outline.pane look panel pane);
        label_above place name;
      ]
  else point_light panel name middle

let spot panel name (beam : Beam.t) =
  Sketch.all
    [
      Sketch.marks (Light_outline.cone ink panel beam);
      point_light panel name beam.position;
    ]

let directional (panel : Panel.t) name (along : Direction.t) =
  let d = (along :> Vec3.t) in
  let dx = Panel.across panel.side d and dy = -.Panel.up panel.side d in
  let length = Float.hypot dx dy in
  if length < 1e-6 then
    let x, y = (panel.left +. inset, panel.top +. inset) in
    label (x +. 50., y +. inset) (name ^ ", along this view")
  else
    let ux = dx /. length and uy = dy /. length in
    let tail = towards_edge panel (-.ux, -.uy) in
    let at = Way.from tail (ux, uy) in
    Sketch.all
      [
        Sketch.busy
          (Rectangle.around (at 17. 0.) 12.)
          [
            Line (Drawing.stroke ~width:3. ink, tail, at 24. 0.);
            Polygon (look, [ at 34. 0.; at 22. 6.; at 22. (-6.) ]);
          ];
        label (at (-12.) 0.) name;
      ]

let draw panel ~shown lights =
  let mark i (light : Light.t) =
    let number = i + 1 in
    let name = Printf.sprintf "light %d" number in
    match light.source with
    | Spherical position -> point_light panel name position
    | Spot beam -> spot panel name beam
    | Area pane -> area panel name pane
    | Directional along ->
        if List.mem number shown then Sketch.all []
        else directional panel name along
  in
  Sketch.all (List.mapi mark (List.filteri (fun i _ -> i < most) lights))
