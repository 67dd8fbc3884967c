open Raylab_geometry

type t = { fill : Drawing.color; is_met : bool }

let outline { is_met; _ } =
  if is_met then Drawing.stroke ~width:1.6 0x222222
  else Drawing.stroke ~width:0.8 0x999999

let opacity { is_met; _ } = if is_met then 0.55 else 0.3
let area s opacity = Drawing.filled ~opacity ~outline:(outline s) s.fill

(* Renderers do not like circles of a million pixels: near the panel such a one
   is as good as straight. *)
let straight = 2e4

(* A sphere that is all around the rest must not hide it. *)
let ball_opacity (panel : Panel.t) s radius =
  if radius > 0.4 *. Float.min panel.width panel.height then 0.08
  else opacity s

let ball (panel : Panel.t) s (sphere : Sphere.t) =
  let centre = Panel.point panel (Sphere.centre sphere) in
  let r = panel.scale *. sphere.radius in
  if r < straight then
    Drawing.Circle (area s (ball_opacity panel s r), centre, r)
  else
    let _, way = Way.between centre (Panel.middle panel) in
    let at = Way.from centre way r in
    Line (outline s, at (-.straight), at straight)

(* The line in which the plane cuts the plane of the panel at [level]. *)
let trace (panel : Panel.t) { Plane.point; normal } level =
  let n = (normal :> Vec3.t) in
  let a = Panel.across panel.side n and b = Panel.up panel.side n in
  let squared = (a *. a) +. (b *. b) in
  if squared < 1e-12 then None
  else
    let rest =
      Vec3.dot n point -. (level *. Panel.towards_viewer panel.side n)
    in
    let in_space u v =
      match panel.side with
      | Above -> Vec3.make u level v
      | Beside -> Vec3.make level v u
    in
    let k = rest /. squared in
    let from = in_space (k *. a) (k *. b) in
    let along = Vec3.sub (in_space (-.b) a) (in_space 0. 0.) in
    Panel.line panel from along

let cut { is_met; _ } (a, b) =
  let pen =
    if is_met then Drawing.stroke ~width:3. 0x555555
    else Drawing.stroke ~width:1.5 0xaaaaaa
  in
  Drawing.Line (pen, a, b)

(* Where the label of a circle or a line stands. *)
let ball_place (panel : Panel.t) (sphere : Sphere.t) =
  let x, y = Panel.point panel (Sphere.centre sphere) in
  let r = panel.scale *. sphere.radius in
  if r < 24. then (x, y -. r -. 7.) else (x, y +. 4.)

let cut_place ((x, y), (x', y')) =
  let along = if x > x' then 0.2 else 0.8 in
  (x +. (along *. (x' -. x)), y +. (along *. (y' -. y)) -. 7.)

let is_near (x, y) = abs_float x < straight && abs_float y < straight
let polygon s places = Drawing.Polygon (area s (opacity s), places)

let label_place places =
  let count = float_of_int (List.length places) in
  let mean pick =
    List.fold_left (fun sum p -> sum +. pick p) 0. places /. count
  in
  (mean fst, mean snd -. 7.)

(* A piece of a plane. One that reaches far beyond the panel is left out. *)
let patch panel s corners =
  let places = List.map (Panel.point panel) corners in
  if List.for_all is_near places then
    Some ([ polygon s places ], label_place places)
  else None

(* One of many, which together show the form: with a thin outline. *)
let piece s places =
  let outline = Drawing.stroke ~width:0.5 0x666666 in
  Drawing.Polygon (Drawing.filled ~opacity:(opacity s) ~outline s.fill, places)

(* The pieces of a body, each as the area between all its points; likewise. *)
let body panel s pieces =
  let pieces = List.map (List.map (Panel.point panel)) pieces in
  let places = List.concat pieces in
  let hulls = List.map Convex_hull.of_points pieces in
  if not (List.for_all is_near places) then None
  else
    let draw = match hulls with [ _ ] -> polygon s | _ -> piece s in
    Some (List.map draw hulls, label_place places)

let rec draw panel s ~level : Outline.t -> _ = function
  | Ball sphere -> [ ([ ball panel s sphere ], ball_place panel sphere) ]
  | Endless plane ->
      let cut ends = ([ cut s ends ], cut_place ends) in
      Option.to_list (Option.map cut (trace panel plane level))
  | Patch corners -> Option.to_list (patch panel s corners)
  | Body pieces -> Option.to_list (body panel s pieces)
  | Several outlines -> List.concat_map (draw panel s ~level) outlines
