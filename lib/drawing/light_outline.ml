open Raylab_geometry
open Raylab_expression
open Raylab_scene

(* The sides between these places, as far as the panel shows them. *)
let outline panel pen = function
  | [] -> []
  | first :: rest as places ->
      let box = Panel.box panel in
      let side a b =
        Option.map
          (fun (a, b) -> Drawing.Line (pen, a, b))
          (Clip.segment box (a, b))
      in
      List.filter_map Fun.id (List.map2 side places (rest @ [ first ]))

let middle pane =
  let corners = Pane.corners pane in
  Vec3.scale 0.25 (List.fold_left Vec3.add Vec3.zero corners)

let pane look panel pane =
  let places = List.map (Panel.point panel) (Pane.corners pane) in
  let pen =
    Option.value look.Drawing.outline ~default:(Drawing.stroke ~width:1. 0)
  in
  (if List.for_all (Panel.shows panel) places then
     [ Drawing.Polygon ({ look with opacity = 0.35 }, places) ]
   else [])
  @ outline panel { pen with width = 3. } places

(* Of the rim of the cone: enough points for it to look round. *)
let rim (beam : Beam.t) =
  let open Vec3.Infix in
  let axis = (beam.axis :> Vec3.t) in
  let length = Vec3.length (beam.target - beam.position)
  and aside =
    if abs_float axis.x < 0.5 then Vec3.make 1. 0. 0. else Vec3.make 0. 1. 0.
  in
  let across = (Direction.of_vec3_exn (Vec3.cross axis aside) :> Vec3.t) in
  let above = Vec3.cross across axis and slope = Degrees.sin beam.outer in
  let at k =
    let angle = float_of_int k *. 15. in
    let around = (Degrees.cos angle * across) + (Degrees.sin angle * above) in
    beam.position + (length * ((beam.none * axis) + (slope * around)))
  in
  List.init 24 at

let cone ink panel (beam : Beam.t) =
  if beam.outer >= 90. then []
  else
    List.map (Panel.point panel) (beam.position :: rim beam)
    |> Convex_hull.of_points
    |> outline panel (Drawing.stroke ~width:1. ink)
