open Raylab_geometry
open Raylab_scene

let most = 20
let inset = 24.
let ink = "#b26a00"

let style =
  Printf.sprintf {|fill="#ffd54f" stroke="%s" stroke-width="1.5"|} ink

let rays = Printf.sprintf {|stroke="%s" stroke-width="1.5"|} ink

let label (x, y) words =
  Drawn.label (Label.make ~anchor:"middle" ~color:ink [ (x, y +. 4.) ] words)

let label_above (x, y) words = label (x, y -. 18.) words

let sun ((x, y) as centre) =
  let ray k =
    let angle = float_of_int k *. Float.pi /. 4. in
    let at r = (x +. (r *. cos angle), y +. (r *. sin angle)) in
    Svg.line ~style:rays (at 6.5) (at 10.)
  in
  Drawn.mark
    (Rectangle.around centre 10.)
    (Svg.circle ~style centre 5. :: List.init 8 ray)

(* The middle of the panel, and the panel without its edges. *)
let middle { View.left; top; width; height; _ } =
  (left +. (width /. 2.), top +. (height /. 2.))

(* [towards_edge view d] is the place near the edge of the panel in direction
   [d], in pixels, from its middle. *)
let towards_edge (view : View.t) (dx, dy) =
  let x, y = middle view in
  let reach size d =
    if d = 0. then infinity else ((size /. 2.) -. inset) /. abs_float d
  in
  let t = Float.min (reach view.width dx) (reach view.height dy) in
  (x +. (t *. dx), y +. (t *. dy))

let point_light view name position =
  let ((x, y) as place) = View.point view position in
  if View.contains view place then
    Drawn.all [ sun place; label_above place name ]
  else
    let mx, my = middle view in
    let edge = towards_edge view (x -. mx, y -. my) in
    Drawn.all [ sun edge; label_above edge (name ^ ", farther away") ]

let directional view name (along : Direction.t) =
  let d = (along :> Vec3.t) in
  let dx = View.across view.View.side d and dy = -.View.up view.side d in
  let length = Float.hypot dx dy in
  if length < 1e-6 then
    let x, y = (view.left +. inset, view.top +. inset) in
    label (x +. 50., y +. inset) (name ^ ", along this view")
  else
    let ux = dx /. length and uy = dy /. length in
    let ((x, y) as tail) = towards_edge view (-.ux, -.uy) in
    let at along aside =
      (x +. (along *. ux) -. (aside *. uy), y +. (along *. uy) +. (aside *. ux))
    in
    let thick = Printf.sprintf {|stroke="%s" stroke-width="3"|} ink in
    Drawn.all
      [
        Drawn.mark
          (Rectangle.around (at 17. 0.) 12.)
          [
            Svg.line ~style:thick tail (at 24. 0.);
            Svg.polygon ~style [ at 34. 0.; at 22. 6.; at 22. (-6.) ];
          ];
        label (at (-12.) 0.) name;
      ]

let draw view ~shown lights =
  let mark i (light : Light.t) =
    let number = i + 1 in
    let name = Printf.sprintf "light %d" number in
    match light.source with
    | Spherical position -> point_light view name position
    | Directional along ->
        if List.mem number shown then Drawn.all []
        else directional view name along
  in
  Drawn.all (List.mapi mark (List.filteri (fun i _ -> i < most) lights))
