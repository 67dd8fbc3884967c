open Raylab_geometry
open Raylab_scene
open Raylab_tracer

let pf = Printf.sprintf

let css color =
  let r, g, b = Color.to_bytes color in
  pf "rgb(%d,%d,%d)" r g b

(* A mirror has no colour of its own. *)
let fill (o : Object.t) =
  let { Lobes.emission; albedo; mirror } = Surface.lobes o.surface in
  let own = Saturate.color (Color.add emission albedo) in
  if Color.largest mirror > 0. && Color.equal own Color.black then
    "rgb(205,218,228)"
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
    match Shape.box object_.shape with
    | None -> (infinity, neg_infinity)
    | Some box ->
        (Box3.reach box, View.towards_viewer view.side (Box3.centre box))
  in
  { number; object_; is_met = Hashtbl.mem met number; size; nearness }

(* Whether a shape shows anything in the panel. *)
let is_visible (view : View.t) item =
  match Shape.box item.object_.shape with
  | None -> true
  | Some { low; high } ->
      let left, bottom = View.point view low
      and right, top = View.point view high in
      right > view.left
      && left < view.left +. view.width
      && bottom > view.top
      && top < view.top +. view.height

let most_objects = 300

let chosen view met (scene : Scene.t) =
  let items = List.mapi (fun i o -> item view met (i + 1) o) scene.objects in
  let by_size a b = compare (b.is_met, b.size) (a.is_met, a.size) in
  List.filter (is_visible view) items
  |> List.stable_sort by_size
  |> List.filteri (fun i _ -> i < most_objects)
  |> List.stable_sort (fun a b -> Float.compare a.nearness b.nearness)

let name { number; object_; _ } place =
  let words = pf "%s %d" (Shape.name object_.shape) number in
  Drawn.label (Label.make ~anchor:"middle" [ place ] words)

let bare_number { number; _ } place =
  Drawn.label
    (Label.make ~anchor:"middle" ~size:10. ~color:"#888" ~reach:30. [ place ]
       (string_of_int number))

(* {1 All of them} *)

(* At which level a shape is cut: that of its first hit, or of the eye. *)
let levels side e =
  let levels = Hashtbl.create 16 in
  List.iter
    (fun ((h : Explain.surface_hit), _) ->
      if not (Hashtbl.mem levels h.hit.number) then
        Hashtbl.add levels h.hit.number (View.towards_viewer side h.hit.point))
    (Path.hits e);
  fun number -> Option.value (Hashtbl.find_opt levels number) ~default:0.

(* At most so many objects that are not met are numbered. *)
let few = 30

(* The objects, the names of those that are met, the numbers of the others. *)
let objects (view : View.t) scene e =
  let met = Hashtbl.create 16 in
  List.iter (fun number -> Hashtbl.replace met number ()) (Path.objects e);
  let level = levels view.side e in
  let items = chosen view met scene in
  let draw item =
    let look = { Silhouette.fill = fill item.object_; is_met = item.is_met } in
    Shape.outline item.object_.shape
    |> Silhouette.draw view look ~level:(level item.number)
    |> Option.map (fun (shape, place) -> (item, shape, place))
  in
  let drawn = List.filter_map draw items in
  let names (item, _, place) =
    if item.is_met then Some (name item place) else None
  and numbers (item, _, place) =
    if (not item.is_met) && View.contains view place then
      Some (bare_number item place)
    else None
  in
  ( Drawn.shapes (List.map (fun (_, shape, _) -> shape) drawn),
    Drawn.all (List.filter_map names drawn),
    if List.compare_length_with items few <= 0 then
      Drawn.all (List.filter_map numbers drawn)
    else Drawn.all [] )

(* {1 Eye and canvas} *)

let eye_and_canvas view
    { Camera.canvas_width = w; canvas_height = h; depth; _ } =
  let low, high =
    match view.View.side with
    | Above -> (Vec3.make (w /. -2.) 0. 0., Vec3.make (w /. 2.) 0. 0.)
    | Beside -> (Vec3.make 0. (h /. -2.) 0., Vec3.make 0. (h /. 2.) 0.)
  in
  let ((x, y) as eye) = View.point view (Vec3.make 0. 0. (-.depth)) in
  let ((x', y') as top) = View.point view high in
  Drawn.all
    [
      Drawn.shapes
        [
          Svg.line ~style:{|stroke="#00897b" stroke-width="2.5"|}
            (View.point view low) top;
        ];
      Drawn.mark (Rectangle.around eye 6.)
        [
          Svg.circle ~style:{|fill="white" stroke="#222" stroke-width="1.5"|}
            eye 5.5;
          Svg.circle ~style:{|fill="#222"|} eye 2.4;
        ];
      Drawn.label (Label.make [ (x +. 9., y +. 12.) ] "eye");
      Drawn.label
        (Label.make ~color:"#00695c" ~size:11.
           [ (x' +. 5., y' -. 3.) ]
           "canvas");
    ]

let draw view (scene : Scene.t) e =
  let shapes, names, numbers = objects view scene e in
  (Drawn.all [ shapes; eye_and_canvas view scene.camera; names ], numbers)
