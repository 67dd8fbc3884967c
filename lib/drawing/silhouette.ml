open Raylab_geometry

let pf = Printf.sprintf

type look = { fill : string; is_met : bool }

let stroke look =
  if look.is_met then {|stroke="#222" stroke-width="1.6"|}
  else {|stroke="#999" stroke-width="0.8"|}

(* Renderers do not like circles of a million pixels: near the panel such a one
   is as good as straight. *)
let straight = 2e4

(* A sphere that is all around the rest must not hide it. *)
let opacity (view : View.t) look radius =
  if radius > 0.4 *. Float.min view.width view.height then 0.08
  else if look.is_met then 0.55
  else 0.3

let ball (view : View.t) look (sphere : Sphere.t) =
  let ((x, y) as centre) = View.point view (Sphere.centre sphere) in
  let r = view.scale *. sphere.radius in
  if r < straight then
    let style =
      pf {|fill="%s" fill-opacity="%g" %s|} look.fill (opacity view look r)
        (stroke look)
    in
    Svg.circle ~style centre r
  else
    let dx = view.left +. (view.width /. 2.) -. x
    and dy = view.top +. (view.height /. 2.) -. y in
    let way = Float.hypot dx dy in
    let ux = dx /. way and uy = dy /. way in
    let at along =
      (x +. (r *. ux) -. (along *. uy), y +. (r *. uy) +. (along *. ux))
    in
    let style = pf {|fill="none" %s|} (stroke look) in
    Svg.line ~style (at (-.straight)) (at straight)

(* The line in which the plane cuts the plane of the view at [level]. *)
let trace (view : View.t) { Plane.point; normal } level =
  let n = (normal :> Vec3.t) in
  let a = View.across view.side n and b = View.up view.side n in
  let squared = (a *. a) +. (b *. b) in
  if squared < 1e-12 then None
  else
    let rest =
      Vec3.dot n point -. (level *. View.towards_viewer view.side n)
    in
    let in_space u v =
      match view.side with
      | Above -> Vec3.make u level v
      | Beside -> Vec3.make level v u
    in
    let k = rest /. squared in
    let from = in_space (k *. a) (k *. b) in
    let along = Vec3.sub (in_space (-.b) a) (in_space 0. 0.) in
    View.line view from along

let cut look (a, b) =
  let style =
    pf {|stroke="%s" stroke-width="%g"|}
      (if look.is_met then "#555" else "#aaa")
      (if look.is_met then 3. else 1.5)
  in
  Svg.line ~style a b

(* Where the label of a circle or a line stands. *)
let ball_place (view : View.t) (sphere : Sphere.t) =
  let x, y = View.point view (Sphere.centre sphere) in
  let r = view.scale *. sphere.radius in
  if r < 24. then (x, y -. r -. 7.) else (x, y +. 4.)

let cut_place ((x, y), (x', y')) =
  let along = if x > x' then 0.2 else 0.8 in
  (x +. (along *. (x' -. x)), y +. (along *. (y' -. y)) -. 7.)

(* A piece of a plane. One that reaches far beyond the panel is left out. *)
let patch view look corners =
  let places = List.map (View.point view) corners in
  let is_near (x, y) = abs_float x < straight && abs_float y < straight in
  if List.for_all is_near places then
    let count = float_of_int (List.length places) in
    let mean pick =
      List.fold_left (fun sum p -> sum +. pick p) 0. places /. count
    and opacity = if look.is_met then 0.55 else 0.3 in
    let style =
      pf {|fill="%s" fill-opacity="%g" %s|} look.fill opacity (stroke look)
    in
    Some (Svg.polygon ~style places, (mean fst, mean snd -. 7.))
  else None

let draw view look ~level : Outline.t -> _ = function
  | Ball sphere -> Some (ball view look sphere, ball_place view sphere)
  | Endless plane ->
      let cut ends = (cut look ends, cut_place ends) in
      Option.map cut (trace view plane level)
  | Patch corners -> patch view look corners
