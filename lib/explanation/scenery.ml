open Raylab_geometry
open Raylab_scene
open Raylab_tracer

let pf = Printf.sprintf

let css color =
  let r, g, b = Color.to_bytes color in
  pf "rgb(%d,%d,%d)" r g b

(* A mirror has no colour of its own. *)
let fill (o : Object.t) =
  let { Surface.emission; albedo; mirror } = Surface.meaning o.surface in
  let own = Saturate.color (Color.add emission albedo) in
  if mirror > 0. && Color.equal own Color.black then "rgb(205,218,228)"
  else css own

(* {1 Objects} *)

type item = {
  number : int;
  object_ : Object.t;
  is_met : bool;
  size : float;
  nearness : float;
}

let item (view : View.t) met number (object_ : Object.t) =
  let size, nearness =
    match object_.shape with
    | Plane _ -> (infinity, neg_infinity)
    | Sphere sphere ->
        (sphere.radius, View.towards_viewer view.side (Sphere.centre sphere))
  in
  { number; object_; is_met = Hashtbl.mem met number; size; nearness }

(* Whether a circle shows anything in the panel. *)
let is_visible (view : View.t) item =
  match item.object_.shape with
  | Plane _ -> true
  | Sphere sphere ->
      let x, y = View.point view (Sphere.centre sphere) in
      let r = view.scale *. sphere.radius in
      x +. r > view.left
      && x -. r < view.left +. view.width
      && y +. r > view.top
      && y -. r < view.top +. view.height

let most_objects = 300

let chosen view met (scene : Scene.t) =
  let items = List.mapi (fun i o -> item view met (i + 1) o) scene.objects in
  let by_size a b = compare (b.is_met, b.size) (a.is_met, a.size) in
  List.filter (is_visible view) items
  |> List.stable_sort by_size
  |> List.filteri (fun i _ -> i < most_objects)
  |> List.stable_sort (fun a b -> Float.compare a.nearness b.nearness)

let stroke item =
  if item.is_met then {|stroke="#222" stroke-width="1.6"|}
  else {|stroke="#999" stroke-width="0.8"|}

(* Renderers do not like circles of a million pixels: near the panel such a one
   is as good as straight. *)
let straight = 2e4

(* A sphere that is all around the rest must not hide it. *)
let opacity (view : View.t) item radius =
  if radius > 0.4 *. Float.min view.width view.height then 0.08
  else if item.is_met then 0.55
  else 0.3

let sphere (view : View.t) item (sphere : Sphere.t) =
  let ((x, y) as centre) = View.point view (Sphere.centre sphere) in
  let r = view.scale *. sphere.radius in
  if r < straight then
    let style =
      pf {|fill="%s" fill-opacity="%g" %s|} (fill item.object_)
        (opacity view item r) (stroke item)
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
    let style = pf {|fill="none" %s|} (stroke item) in
    Svg.line ~style (at (-.straight)) (at straight)

(* The line in which the plane cuts the plane of the view at [level]. *)
let trace (view : View.t) { Plane.point; normal } level =
  let n = (normal :> Vec3.t) in
  let a = View.across view.side n and b = View.up view.side n in
  let squared = (a *. a) +. (b *. b) in
  if squared < 1e-12 then None
  else
    let rest = Vec3.dot n point -. (level *. View.towards_viewer view.side n) in
    let in_space u v =
      match view.side with
      | Above -> Vec3.make u level v
      | Beside -> Vec3.make level v u
    in
    let k = rest /. squared in
    let from = in_space (k *. a) (k *. b) in
    let along = Vec3.sub (in_space (-.b) a) (in_space 0. 0.) in
    View.line view from along

let plane item (a, b) =
  let style =
    pf {|stroke="%s" stroke-width="%g"|}
      (if item.is_met then "#555" else "#aaa")
      (if item.is_met then 3. else 1.5)
  in
  Svg.line ~style a b

(* {1 Labels} *)

(* Where the label of a circle or a line stands. *)
let sphere_place (view : View.t) (sphere : Sphere.t) =
  let x, y = View.point view (Sphere.centre sphere) in
  let r = view.scale *. sphere.radius in
  if r < 24. then (x, y -. r -. 7.) else (x, y +. 4.)

let plane_place ((x, y), (x', y')) =
  let along = if x > x' then 0.2 else 0.8 in
  (x +. (along *. (x' -. x)), y +. (along *. (y' -. y)) -. 7.)

let label view { number; object_; is_met; _ } ~few place =
  if is_met then
    let name = pf "%s %d" (Shape.name object_.shape) number in
    [ Svg.text ~anchor:"middle" (View.inside view place) name ]
  else if few && View.contains view place then
    let color = "#888" in
    [ Svg.text ~anchor:"middle" ~size:10. ~color place (string_of_int number) ]
  else []

(* {1 All of them} *)

type t = { shapes : Svg.t list; labels : Svg.t list }

(* At which level a plane is cut: that of its first hit, or of the eye. *)
let levels side e =
  let levels = Hashtbl.create 16 in
  List.iter
    (fun ((h : Explain.surface_hit), _) ->
      if not (Hashtbl.mem levels h.hit.number) then
        Hashtbl.add levels h.hit.number (View.towards_viewer side h.hit.point))
    (Path.hits e);
  fun number -> Option.value (Hashtbl.find_opt levels number) ~default:0.

let objects (view : View.t) scene e =
  let met = Hashtbl.create 16 in
  List.iter (fun number -> Hashtbl.replace met number ()) (Path.objects e);
  let level = levels view.side e in
  let items = chosen view met scene in
  let few = List.compare_length_with items 30 <= 0 in
  let one item =
    match item.object_.shape with
    | Sphere s ->
        let place = sphere_place view s in
        Some (sphere view item s, label view item ~few place)
    | Plane p ->
        let cut = trace view p (level item.number) in
        let draw ends =
          (plane item ends, label view item ~few (plane_place ends))
        in
        Option.map draw cut
  in
  let shapes, labels = List.split (List.filter_map one items) in
  { shapes; labels = List.concat labels }

(* {1 Eye and canvas} *)

let eye_and_canvas view { Camera.canvas_width = w; canvas_height = h; depth; _ }
    =
  let low, high =
    match view.View.side with
    | Above -> (Vec3.make (w /. -2.) 0. 0., Vec3.make (w /. 2.) 0. 0.)
    | Beside -> (Vec3.make 0. (h /. -2.) 0., Vec3.make 0. (h /. 2.) 0.)
  in
  let ((x, y) as eye) = View.point view (Vec3.make 0. 0. (-.depth)) in
  let ((x', y') as top) = View.point view high in
  [
    Svg.line ~style:{|stroke="#00897b" stroke-width="2.5"|}
      (View.point view low) top;
    Svg.text ~color:"#00695c" ~size:11. (x' +. 5., y' -. 3.) "canvas";
    Svg.circle ~style:{|fill="white" stroke="#222" stroke-width="1.5"|} eye 5.5;
    Svg.circle ~style:{|fill="#222"|} eye 2.4;
    Svg.text (x +. 9., y +. 12.) "eye";
  ]

let draw view (scene : Scene.t) e =
  let { shapes; labels } = objects view scene e in
  { shapes = shapes @ eye_and_canvas view scene.camera; labels }
