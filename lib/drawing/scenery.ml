open Raylab_geometry
open Raylab_scene

let pf = Printf.sprintf

(* A mirror has no colour of its own. *)
let mirror_color = Color.make (205. /. 255.) (218. /. 255.) (228. /. 255.)
let unknown = Drawing.Seen (Color.make 0.5 0.5 0.5)

(* Nor has glass much: its tint, on something pale. *)
let glass_color { Lobes.plain; glass; _ } =
  let { Color.r; g; b } = Color.add plain glass in
  let pale c = 0.55 +. (0.4 *. Float.min 1. c) in
  Color.make (pale r) (pale g) (pale b)

let rec fill (o : Object.t) =
  match Surface.lobes o.surface with
  | lobes -> fill_with lobes
  | exception Pattern.Failed _ -> unknown

and fill_with { Lobes.emission; albedo; mirror; refractions; _ } =
  let own = Saturate.color (Color.add emission albedo) in
  match refractions with
  | _ when not (Color.equal own Color.black) -> Drawing.Seen own
  | refraction :: _ -> Seen (glass_color refraction)
  | [] when Color.largest mirror > 0. -> Seen mirror_color
  | [] -> Seen own

(* {1 Objects} *)

type item = {
  number : int;
  object_ : Object.t;
  is_met : bool;
  size : float;
  nearness : float;
}

let item (panel : Panel.t) met number (object_ : Object.t) =
  let size, nearness =
    match Shape.box object_.shape with
    | None -> (infinity, neg_infinity)
    | Some box ->
        (Box3.reach box, Panel.towards_viewer panel.side (Box3.centre box))
  in
  { number; object_; is_met = Hashtbl.mem met number; size; nearness }

(* Whether a shape shows anything in the panel. *)
let is_visible (panel : Panel.t) item =
  match Shape.box item.object_.shape with
  | None -> true
  | Some { low; high } ->
      let left, bottom = Panel.point panel low
      and right, top = Panel.point panel high in
      right > panel.left
      && left < panel.left +. panel.width
      && bottom > panel.top
      && top < panel.top +. panel.height

let most_objects = 300

let chosen panel met (scene : Scene.t) =
  let items = List.mapi (fun i o -> item panel met (i + 1) o) scene.objects in
  let by_size a b = compare (b.is_met, b.size) (a.is_met, a.size) in
  List.filter (is_visible panel) items
  |> List.stable_sort by_size
  |> List.filteri (fun i _ -> i < most_objects)
  |> List.stable_sort (fun a b -> Float.compare a.nearness b.nearness)

let name { number; object_; _ } place =
  let words = pf "%s %d" (Shape.name object_.shape) number in
  Sketch.label (Label.make ~anchor:Middle [ place ] words)

let bare_number { number; _ } place =
  Sketch.label
    (Label.make ~anchor:Middle ~size:10. ~ink:0x888888 ~reach:30. [ place ]
       (string_of_int number))

(* {1 All of them} *)

(* At which level a shape is cut: that of its first hit, or of the eye. *)
let levels side camera { Path.hits; _ } =
  let levels = Hashtbl.create 16 in
  List.iter
    (fun { Path.number; point; _ } ->
      if not (Hashtbl.mem levels number) then
        Hashtbl.add levels number (Panel.towards_viewer side point))
    hits;
  let default = Panel.towards_viewer side (Camera.eye camera) in
  fun number -> Option.value (Hashtbl.find_opt levels number) ~default

(* At most so many objects that are not met are numbered. *)
let few = 30

(* The objects, the names of those that are met, the numbers of the others. *)
let objects (panel : Panel.t) (scene : Scene.t) path =
  let met = Hashtbl.create 16 in
  List.iter (fun number -> Hashtbl.replace met number ()) (Path.objects path);
  let level = levels panel.side scene.camera path in
  let items = chosen panel met scene in
  let draw item =
    let s = { Silhouette.fill = fill item.object_; is_met = item.is_met } in
    match
      Shape.outline item.object_.shape
      |> Silhouette.draw panel s ~level:(level item.number)
    with
    | [] -> None
    | (_, place) :: _ as pieces ->
        Some (item, List.concat_map fst pieces, place)
  in
  let drawn = List.filter_map draw items in
  let names (item, _, place) =
    if item.is_met then Some (name item place) else None
  and numbers (item, _, place) =
    if (not item.is_met) && Panel.shows panel place then
      Some (bare_number item place)
    else None
  in
  ( Sketch.marks (List.concat_map (fun (_, marks, _) -> marks) drawn),
    Sketch.all (List.filter_map names drawn),
    if List.compare_length_with items few <= 0 then
      Sketch.all (List.filter_map numbers drawn)
    else Sketch.all [] )

(* {1 Eye and canvas} *)

(* A line where it is seen from its edge, as that of a camera that is not placed
   is from above and from the side. *)
let canvas_mark pen (((ax, ay) as a), ((bx, by) as b), ((cx, cy) as c), d) =
  let area = ((bx -. ax) *. (cy -. ay)) -. ((by -. ay) *. (cx -. ax))
  and along, _ = Way.between a c
  and across, _ = Way.between b d in
  let longer = Float.max along across in
  if abs_float area > pen.Drawing.width *. longer then
    let look = Drawing.filled ~opacity:0.12 ~outline:pen (Ink pen.ink) in
    Drawing.Polygon (look, [ a; b; c; d ])
  else if along >= 0.99 *. longer then Line (pen, a, c)
  else Line (pen, b, d)

let eye_and_canvas panel (camera : Camera.t) =
  let a, b, c, d = Camera.corners camera and point = Panel.point panel in
  let ((x', y') as upper_right) = point c in
  let rim = Drawing.stroke ~width:1.5 0x222222 in
  let ((x, y) as eye) = Panel.point panel (Camera.eye camera) in
  Sketch.all
    [
      Sketch.marks
        [
          canvas_mark
            (Drawing.stroke ~width:2.5 0x00897b)
            (point a, point b, upper_right, point d);
        ];
      Sketch.busy (Rectangle.around eye 6.)
        [
          Circle (Drawing.filled ~outline:rim (Ink 0xffffff), eye, 5.5);
          Circle (Drawing.filled (Ink 0x222222), eye, 2.4);
        ];
      Sketch.label (Label.make [ (x +. 9., y +. 12.) ] "eye");
      Sketch.label
        (Label.make ~ink:0x00695c ~size:11. [ (x' +. 5., y' -. 3.) ] "canvas");
    ]

let draw panel (scene : Scene.t) path =
  let shapes, names, numbers = objects panel scene path in
  (Sketch.all [ shapes; eye_and_canvas panel scene.camera; names ], numbers)
