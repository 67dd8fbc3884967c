open Raylab_geometry

let most = 200
let ink = Ray_look.ink Paper

(* [head ink tip way] is an arrow head of which [tip] is the front. *)
let head ink tip way =
  let at = Way.from tip way in
  Drawing.Polygon
    (Drawing.filled (Ink ink), [ at 0. 0.; at (-11.) 4.5; at (-11.) (-4.5) ])

(* {1 Beside a line} *)

(* Shorter lines have no room for an arrow head and a number. *)
let shortest = 30.

(* An arrow head in the middle of a line. *)
let arrow kind ((x, y) as a) ((x', y') as b) =
  let length, way = Way.between a b in
  let middle = ((x +. x') /. 2., (y +. y') /. 2.) in
  if length < shortest then []
  else [ head (ink kind) (Way.from middle way 6. 0.) way ]

(* The number of a ray, beside its middle or as near to that as there is room.
   Farther from the ray it might be taken for that of another. *)
let number kind k a b =
  let length, way = Way.between a b in
  let place part aside =
    let x, y = Way.from a way (part *. length) aside in
    (x, y +. 4.)
  in
  let places =
    List.concat_map
      (fun part -> [ place part 13.; place part (-13.) ])
      [ 0.5; 0.4; 0.6; 0.3; 0.7; 0.2; 0.8 ]
  in
  if length < shortest then Sketch.all []
  else
    Sketch.label
      (Label.make ~anchor:Middle ~ink:(ink kind) ~reach:0. places
         (string_of_int k))

(* {1 Where rays go} *)

let comes_in { Path.kind; length; _ } = kind = Lit && length = infinity

(* What stands at the edge, where a ray from [a] leaves the panel at [b]. *)
let leaving (panel : Panel.t) (ray : Path.ray) a ((x, y) as b) =
  let is_left = x < panel.left +. (panel.width /. 2.) in
  let anchor = if is_left then Drawing.Start else End in
  let ink = ink ray.kind in
  let place = ((if is_left then x +. 12. else x -. 12.), y +. 14.) in
  let label =
    Sketch.label (Label.make ~anchor ~size:11. ~ink [ place ] ray.words)
  in
  if comes_in ray then
    let _, inwards = Way.between b a in
    let along k = Way.from b inwards k 0. in
    Sketch.all
      [
        Sketch.busy
          (Rectangle.around (along 16.) 8.)
          [ head ink (along 22.) inwards ];
        label;
      ]
  else label

(* A ray that is not followed is only a stub. *)
let stub = 45.

let draw_ray (panel : Panel.t) (ray : Path.ray) =
  let origin = Ray.origin ray.ray
  and direction = (Ray.direction ray.ray :> Vec3.t) in
  let length =
    if ray.kind = Unfollowed then stub /. panel.scale else ray.length
  in
  match Panel.segment panel origin direction length with
  | None -> Sketch.all []
  | Some (a, b) ->
      let ends_inside =
        Float.is_finite length
        && Panel.shows panel (Panel.point panel (Ray.at ray.ray length))
      in
      let leaving = leaving panel ray a b in
      Sketch.all
        [
          Sketch.marks (Ray_look.line ~tint:ray.tint Paper ray.kind a b);
          (match ray.kind with
          | Primary | Mirrored | Refracted ->
              Sketch.all
                [
                  Sketch.marks (arrow ray.kind a b);
                  number ray.kind ray.number a b;
                ]
          | Blocked when ends_inside ->
              Sketch.busy (Rectangle.around b 6.) (Ray_look.cross Paper b)
          | Unfollowed -> leaving
          | Lit | Blocked -> Sketch.all []);
          (if ends_inside then Sketch.all [] else leaving);
        ]

let lights_shown { Path.rays; _ } =
  List.filter_map
    (fun (ray : Path.ray) -> if comes_in ray then ray.light else None)
    rays

(* {1 All of them} *)

let dot panel { Path.point; color; _ } =
  let place = Panel.point panel point in
  let outline = Drawing.stroke ~width:1.2 0x222222 in
  let look = Drawing.filled ~outline (Seen color) in
  if Panel.shows panel place then
    Sketch.busy (Rectangle.around place 5.) [ Circle (look, place, 4.) ]
  else Sketch.all []

let draw panel { Path.rays; hits } =
  let some items = List.filteri (fun i _ -> i < most) items in
  Sketch.all
    (List.map (draw_ray panel) (some rays) @ List.map (dot panel) (some hits))
